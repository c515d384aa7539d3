//! What books write that is not a false number: conventions of notation, each in a chain of ours that must not be listed as wrong,
//! beside one that must.

use crate::report;
use proofread::{ReportSection, TextFormat};

/// What is listed on the number in a text, or set aside as a doubt.
fn numbers(text: &str, format: TextFormat) -> Vec<String> {
    let findings = report(text, format).findings;
    findings
        .iter()
        .filter(|of| matches!(of.section, ReportSection::Numbers | ReportSection::Doubts))
        .map(|of| format!("{} | {}", of.left, of.right))
        .collect()
}

#[track_caller]
fn quiet(format: TextFormat, texts: &[&str]) {
    for text in texts {
        assert_eq!(numbers(text, format), [""; 0], "{text}");
    }
}

#[track_caller]
fn loud(format: TextFormat, texts: &[&str]) {
    for text in texts {
        assert!(!numbers(text, format).is_empty(), "{text}");
    }
}

#[test]
fn an_equals_sign_may_mean_corresponds_to() {
    quiet(
        TextFormat::Markdown,
        &[
            r"Scale: $1\,\text{cm} = 10\,\text{N}$",
            r"On the map, $1\,\text{cm} = 50\,\text{m}$.",
            r"$1\,\text{u} = 931.5\,\text{MeV}$",
            r"$938\,\text{MeV} = 1.67\times10^{-27}\,\text{kg}$",
            r"$300\,\text{K} = 26\,\text{meV}$",
            r"$1\,\text{eV} = 8065\,\text{cm}^{-1}$",
            r"$1\,\text{GeV}^{-1} = 0.197\,\text{fm}$",
            r"$197\,\text{MeV}\,\text{fm} = 1$",
            r"$1\,\text{mol} = 22.4\,\text{L}$",
            r"$18\,\text{g} = 1\,\text{mol} = 6.02\times10^{23}$",
            r"$12\,\text{g} = 6.022\times10^{23}\,\text{atoms}$",
            r"$5\,\text{kg} = 49\,\text{N}$",
            r"$20\,\text{dB} = 100$ and $60\,\text{dB} + 60\,\text{dB} = 63\,\text{dB}$",
            r"$938.3\,\text{MeV}/c^2 + 0.5\,\text{MeV}/c^2 = 938.8\,\text{MeV}/c^2$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[
            r"$1.09\,\text{m}^3 = 1.98\times10^8\,\text{N/m}^2$",
            r"$1.0\,\text{km} = 100\,\text{m}$ of road",
            r"$20\log(10) = 23\,\text{dB}$",
            r"$938.3\,\text{MeV}/c^2 + 0.5\,\text{MeV}/c^2 = 939.8\,\text{MeV}/c^2$",
        ],
    );
}

#[test]
fn factors_of_conversion_are_rounded() {
    quiet(
        TextFormat::Plain,
        &[
            "1 in = 2.5 cm",
            "100 miles = 160 km",
            "5.00 miles = 8.00 km",
            "1 hp = 745.7 W",
            "1 hp = 735.5 W",
            "1 cal = 4.184 J",
            "1 Btu = 1054 J",
            "1 yr = 3.15e7 s",
            "2 yr = 24 months",
            "1 AU = 1.5e8 km",
            "1 kg = 2.2 lb",
        ],
    );
    loud(TextFormat::Plain, &["1 hp = 764 W", "1 yr = 3.51e7 s", "5.00 miles = 9.00 km", "2.00 in = 5.80 cm"]);
}

#[test]
fn equations_of_chemistry_are_no_sums() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$\text{2H}_2 + \text{O}_2 = 2\text{H}_2\text{O}$",
            r"$\mathrm{2C + O_2 = 2CO}$",
            r"$2\,\mathrm{Na} + \mathrm{Cl_2} = 2\,\mathrm{NaCl}$",
            r"$\ce{2H2 + O2 = 2H2O}$",
        ],
    );
    quiet(TextFormat::Plain, &["N2 + 3H2 = 2NH3", "2 C + O2 = 2 CO", "C + 2 S = CS2"]);
}

#[test]
fn lists_steps_times_and_places_are_no_chains() {
    quiet(
        TextFormat::Plain,
        &[
            "1. 2 + 3 = 5",
            "2) 4 + 4 = 8",
            "Step 3: 12 / 4 = 3",
            "x = 3, y = 4, z = 5",
            "Pages 5–7 = 3 pages",
            "10:30 + 1:15 = 11:45",
            "9:00 = 21:00",
            "at 14:30 = 2:30 pm",
            "12.05.2020 = 5",
            "£3.50 × 2 = £7.00",
            "$5 + $6 = $11",
        ],
    );
    quiet(TextFormat::Markdown, &["$x = 3, y = 4$", "$a = 2$, $b = 3$", r"\$5 + \$6 = \$11"]);
    loud(TextFormat::Plain, &["Step 3: 12 / 4 = 5", "2) 4 + 4 = 9"]);
}

#[test]
fn percentages_may_be_of_what_stands_before() {
    quiet(
        TextFormat::Markdown,
        &[r"$200 + 10\% = 220$", r"$80 - 25\% = 60$", r"$\frac{120 - 100}{100} = 20\%$", r"$\frac16 = 0.167 = 16.7\%$"],
    );
    quiet(TextFormat::Plain, &["200 + 19 % = 238", "7 % 2 = 1"]);
    loud(TextFormat::Markdown, &[r"$200 + 10\% = 240$", r"$\frac16 = 17.6\%$"]);
}

#[test]
fn a_logarithm_without_a_base_has_two() {
    quiet(TextFormat::Markdown, &[r"$\log 5.00 = 1.61$", r"$\log 5.00 = 0.699$", r"$\log_2 8 = 3$"]);
    loud(TextFormat::Markdown, &[r"$\log 5.00 = 1.81$", r"$\log_{10} 5.00 = 1.61$", r"$\lg 5.00 = 1.61$"]);
}

#[test]
fn vectors_sets_intervals_and_matrices_are_no_numbers() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$(2, 3) + (1, 1) = (3, 4)$",
            r"$(1, 2)\cdot(3, 4) = 11$",
            r"$|\{1,2,3\}| = 3$",
            r"$[1, 2] = 3$",
            r"$\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix} = 5$",
            r"$\left[\begin{array}{cc} 1 & 2 \\ 3 & 4\end{array}\right] = 2$",
            r"$\det\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix} = -2$",
        ],
    );
}

#[test]
fn congruences_and_other_bases_are_no_differences() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$17 = 2 \pmod 5$",
            r"$17 \bmod 5 = 2$",
            r"$17 = 2\ (\text{mod } 5)$",
            r"$1010_2 = 10_{10}$",
            r"$(1010)_2 = 10$",
        ],
    );
    quiet(TextFormat::Plain, &["17 = 2 mod 5", "7 mod 2 = 1", "17 = 2 (mod 5)", "x = 0x1F = 31", "1010₂ = 10₁₀"]);
}

#[test]
fn minutes_seconds_and_degrees_are_told_apart() {
    quiet(TextFormat::Markdown, &[r"$12^\circ 30' = 12.5^\circ$", r"$1^\circ = 60'$", r"$1' = 60''$"]);
    quiet(TextFormat::Plain, &["12° 30′ = 12.5°", "12°30'36\" = 12.51°"]);
    quiet(
        TextFormat::Markdown,
        &[
            r"$25\,^\circ\text{C} = 298\,\text{K}$",
            r"$25 + 273 = 298\,\text{K}$",
            r"$80\,^\circ\text{C} - 20\,^\circ\text{C} = 60\,\text{K}$",
            r"$98.6\,^\circ\text{F} = 37\,^\circ\text{C}$",
            r"$100\,\text{kPa (gauge)} = 201\,\text{kPa (abs)}$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[r"$25\,^\circ\text{C} = 308\,\text{K}$", r"$80\,^\circ\text{C} - 20\,^\circ\text{C} = 70\,\text{K}$"],
    );
}

#[test]
fn angles_have_another_with_the_same_sine() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$\sin^{-1}(0.500) = 150^\circ$",
            r"$\cos^{-1}(0.500) = 300^\circ$",
            r"$180 - 60 = 120^\circ$",
            r"$60.0\,\text{Hz} = 377\,\text{rad/s}$",
            r"$3000\,\text{rpm} = 314\,\text{rad/s} = 50\,\text{Hz}$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[r"$\sin^{-1}(0.500) = 140^\circ$", r"$180 - 60 = 130^\circ$", r"$60.0\,\text{Hz} = 387\,\text{rad/s}$"],
    );
}

#[test]
fn prices_shares_and_lost_exponents_are_told_apart() {
    quiet(TextFormat::Markdown, &[r"$1\,\text{kWh} = \$0.12$"]);
    quiet(
        TextFormat::Plain,
        &[
            "n = 15 (50%) = 15",
            "1.5 × 10−7 m = 150 nm",
            "10-3 m = 1 mm",
            "5 ms-1 × 2 s = 10 m",
            "v = 5 m s-1 = 18 km h-1",
        ],
    );
    loud(TextFormat::Plain, &["10 - 3 = 8", "5.0 m - 3.0 m = 3.0 m"]);
}

#[test]
fn digits_say_no_more_than_they_do() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$\sqrt{2} \approx 1$",
            r"$\pi^2 \approx 10$",
            r"$15 \times 9.8 \approx 150$",
            r"$347 \approx 300$",
            r"$2.0 \times 3.0 = 6.00$",
            r"$1000/7 = 140$",
            r"$5 = 5.00$",
        ],
    );
    loud(TextFormat::Markdown, &[r"$\sqrt{2} \approx 3$", r"$100/3 = 34.0$", r"$1000/7 = 150$"]);
}

#[test]
fn programs_are_no_formulas() {
    quiet(
        TextFormat::Plain,
        &[
            "i = i + 1",
            "a = 5; b = 7",
            "for i = 1:10",
            "x = 2*3",
            "y = 3//2 = 1",
            "if x = 3 then y = 4",
            "x == 2 + 2 = 5",
        ],
    );
    quiet(TextFormat::Markdown, &["`x = 2*3 = 7`", "```\nx = 2*3 = 7\n```"]);
}

#[test]
fn degrees_and_directions_may_come_with_the_result_only() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$\arctan\left(\frac{3.0}{4.0}\right) \times \frac{180}{\pi} = 36.9^\circ$",
            r"$\arctan(-2.0/-3.0) \times 180/\pi \approx 33.7^\circ + 180^\circ \approx 214^\circ$",
            r"$(4.0\,\text{m})(-3.0\,\text{m}) = (-12\,\text{m}^2)\hat{k}$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[
            r"$\arctan\left(\frac{3.0}{4.0}\right) \times \frac{180}{\pi} = 38.9^\circ$",
            r"$(4.0\,\text{m})(3.0\,\text{m}) = (-12\,\text{m}^2)\hat{k}$",
            r"$12\hat{i} + 3\hat{j} = 12$",
        ],
    );
}

#[test]
fn constants_of_nature_may_be_rounded_or_understood() {
    quiet(
        TextFormat::Markdown,
        &[
            r"$7.88\times10^{-26}\,\text{J} = 4.93\times10^{-7}\,\text{eV}$",
            r"$1000.0\,\text{cm}^{-1} = 11.96\,\text{kJ/mol}$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[
            r"$7.88\times10^{-26}\,\text{J} = 4.95\times10^{-7}\,\text{eV}$",
            r"$7.88\times10^{-26}\,\text{J} = 4.90\times10^{-7}\,\text{eV}$",
        ],
    );
}

#[test]
fn a_wrong_conversion_is_no_correspondence() {
    quiet(
        TextFormat::Markdown,
        &[
            r"On the map, $1\,\text{cm} = 50\,\text{m}$.",
            r"$60\,\text{dB} + 60\,\text{dB} = 63\,\text{dB}$",
            r"$1 = 60\,\text{s}$",
        ],
    );
    loud(
        TextFormat::Markdown,
        &[
            r"On that scale, $1.000\,\text{kcal} = 4106\,\text{J}$.",
            r"$73\,\text{dB} - 70\,\text{dB} = 5\,\text{dB}$",
            r"$10^4 = 1$",
            r"$\$600/(\$235/\text{y}) = 2.9\,\text{y}$",
        ],
    );
}
