//! Decimal digits as the nearest binary number, and the other way round.
//!
//! What the standard library has for both, with a table of ten kilobytes, would be a twentieth of the page's module.

/// The powers of ten that are exact.
pub(crate) const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The number nearest to decimal digits with at most one sign, one point and one exponent, as in `-12.5e3`; none for anything else.
/// What is too large is infinite.
pub(crate) fn parse_decimal(text: &str) -> Option<f64> {
    let (is_negative, unsigned) = match text.as_bytes().first()? {
        b'-' => (true, &text[1..]),
        b'+' => (false, &text[1..]),
        _ => (false, text),
    };
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, i64::from(exponent.parse::<i32>().ok()?)),
        None => (unsigned, 0),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let is_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if whole.len() + decimals.len() == 0 || !is_digits(whole) || !is_digits(decimals) {
        return None;
    }
    let decimals = decimals.trim_end_matches('0');
    let exponent = exponent - decimals.len() as i64;
    let digits = whole.bytes().chain(decimals.bytes()).map(|byte| byte - b'0').skip_while(|digit| *digit == 0);
    let size = match digits.clone().nth(15) {
        // With at most fifteen digits both are exact, and so the product or the quotient is the nearest number.
        None => {
            let all = digits.clone().fold(0, |all: u64, digit| 10 * all + u64::from(digit)) as f64;
            match POWERS_OF_TEN.get(exponent.unsigned_abs() as usize) {
                Some(power) if exponent >= 0 => all * power,
                Some(power) => all / power,
                None => Decimal::new(digits, exponent).nearest(),
            }
        }
        Some(_) => Decimal::new(digits, exponent).nearest(),
    };
    Some(if is_negative { -size } else { size })
}

/// A number with so many decimals, as the standard library's `{:.2}` writes it.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let Some(number) = Decimal::of(value) else { return without_digits(value) };
    let keep = number.power + decimals as i64;
    let number = number.rounded_to(keep);
    let mut out = sign(value).to_owned();
    match number.power {
        ..=0 => out.push('0'),
        whole => (0..whole).for_each(|at| out.push(number.digit(at))),
    }
    if decimals > 0 {
        out.push('.');
    }
    (0..decimals as i64).for_each(|at| out.push(number.digit(number.power + at)));
    out
}

/// A number from 1 to 10 with so many decimals and a power of ten, as the standard library's `{:.2e}` writes it.
pub(crate) fn scientific(value: f64, decimals: usize) -> String {
    let Some(number) = Decimal::of(value) else { return without_digits(value) };
    let number = number.rounded_to(decimals as i64 + 1);
    let mut out = sign(value).to_owned();
    out.push(number.digit(0));
    if decimals > 0 {
        out.push('.');
    }
    (1..=decimals as i64).for_each(|at| out.push(number.digit(at)));
    let exponent = if number.digits.is_empty() { 0 } else { number.power - 1 };
    out + "e" + &exponent.to_string()
}

fn sign(value: f64) -> &'static str {
    if value.is_sign_negative() { "-" } else { "" }
}

fn without_digits(value: f64) -> String {
    if value.is_nan() { "NaN".to_owned() } else { sign(value).to_owned() + "inf" }
}

/// Most digits that are kept. Those of a number that is half way between two others are fewer; of what is behind them counts
/// only whether it is zero.
const MOST_DIGITS: usize = 800;

/// Most bits by which digits are shifted at once.
const MOST_BITS: u32 = 27;

/// Digits behind a point, the first and the last of which are not zero, times a power of ten.
struct Decimal {
    digits: Vec<u8>,
    power: i64,
}

impl Decimal {
    /// A whole number times a power of ten.
    fn new(digits: impl Iterator<Item = u8>, exponent: i64) -> Self {
        let mut number = Self { digits: digits.collect(), power: exponent };
        number.power += number.digits.len() as i64;
        number.trim();
        number
    }

    /// All digits of a number without its sign; none if it is not finite.
    fn of(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.abs().to_bits();
        let (biased, rest) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
        let (mantissa, exponent) = if biased == 0 { (rest, -1074) } else { (rest | 1 << 52, biased - 1075) };
        // Zero has no bit.
        let even = mantissa.trailing_zeros().min(52);
        let mut exponent = exponent + even as i32;
        let mut number = Self::new((mantissa >> even).to_string().bytes().map(|byte| byte - b'0'), 0);
        while exponent > 0 {
            let times = MOST_BITS.min(exponent as u32);
            number.double(times);
            exponent -= times as i32;
        }
        while exponent < 0 {
            let times = MOST_BITS.min(exponent.unsigned_abs());
            number.halve(times);
            exponent += times as i32;
        }
        Some(number)
    }

    /// The digit so many places behind the first one; a zero where there is none.
    fn digit(&self, at: i64) -> char {
        let digit = usize::try_from(at).ok().and_then(|at| self.digits.get(at));
        char::from(b'0' + digit.copied().unwrap_or(0))
    }

    /// Rounded to so many of its digits, half way to the even one.
    fn rounded_to(mut self, keep: i64) -> Self {
        let Ok(keep) = usize::try_from(keep) else { return Self { digits: Vec::new(), power: 0 } };
        let is_odd = keep.checked_sub(1).and_then(|last| self.digits.get(last)).is_some_and(|last| last % 2 == 1);
        let is_up = match self.digits.get(keep..).unwrap_or_default() {
            [] => return self,
            [5] => is_odd,
            [first, ..] => *first >= 5,
        };
        self.digits.truncate(keep);
        if is_up {
            while self.digits.last() == Some(&9) {
                self.digits.pop();
            }
            match self.digits.last_mut() {
                Some(last) => *last += 1,
                None => {
                    self.digits.push(1);
                    self.power += 1;
                }
            }
        }
        self
    }

    fn trim(&mut self) {
        if self.digits.len() > MOST_DIGITS {
            let is_more = self.digits.drain(MOST_DIGITS..).any(|digit| digit != 0);
            self.digits.extend(is_more.then_some(1));
        }
        let zeros = self.digits.iter().take_while(|digit| **digit == 0).count();
        self.digits.drain(..zeros);
        self.power -= zeros as i64;
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
    }

    fn halve(&mut self, times: u32) {
        let (mut rest, mut out) = (0, Vec::new());
        let mut digits = self.digits.iter();
        loop {
            let next = digits.next();
            if next.is_none() && (rest == 0 || out.len() > MOST_DIGITS) {
                break;
            }
            rest = 10 * rest + u64::from(next.copied().unwrap_or(0));
            out.push((rest >> times) as u8);
            rest &= (1 << times) - 1;
        }
        out.extend((rest > 0).then_some(1));
        self.digits = out;
        self.trim();
    }

    fn double(&mut self, times: u32) {
        let (mut carried, mut out) = (0, Vec::new());
        let mut digits = self.digits.iter().rev();
        loop {
            let next = digits.next();
            if next.is_none() && carried == 0 {
                break;
            }
            carried += u64::from(next.copied().unwrap_or(0)) << times;
            out.push((carried % 10) as u8);
            carried /= 10;
        }
        self.power += (out.len() - self.digits.len()) as i64;
        out.reverse();
        self.digits = out;
        self.trim();
    }

    /// The nearest whole number, the even one of two.
    fn rounded(&self) -> u64 {
        let end = self.power.max(0) as usize;
        let whole = (0..end).map(|at| self.digits.get(at).copied().unwrap_or(0));
        let whole = whole.fold(0, |all: u64, digit| 10 * all + u64::from(digit));
        let rest = if self.power < 0 { &[] } else { self.digits.get(end..).unwrap_or_default() };
        let is_up = match rest {
            [] => false,
            [5] => whole % 2 == 1,
            [first, ..] => *first >= 5,
        };
        whole + u64::from(is_up)
    }

    /// The nearest binary number.
    fn nearest(mut self) -> f64 {
        // How often powers of ten can be halved or doubled without passing one.
        const SAFE: [u32; 9] = [1, 3, 6, 9, 13, 16, 19, 23, 26];
        let safe = |power: i64| SAFE.get(power.unsigned_abs() as usize).copied().unwrap_or(MOST_BITS);
        if self.digits.is_empty() || self.power < -330 {
            return 0.0;
        }
        if self.power > 310 {
            return f64::INFINITY;
        }
        // From one half up to one, times a power of two.
        let mut exponent = 0;
        while self.power > 0 {
            let times = safe(self.power);
            self.halve(times);
            exponent += times as i32;
        }
        while self.power < 0 || self.digits.first().is_some_and(|first| *first < 5) {
            let times = safe(self.power);
            self.double(times);
            exponent -= times as i32;
        }
        // The smallest numbers have fewer bits.
        while exponent < -1021 {
            let times = MOST_BITS.min((-1021 - exponent) as u32);
            self.halve(times);
            exponent += times as i32;
        }
        self.double(MOST_BITS);
        self.double(53 - MOST_BITS);
        let mut mantissa = self.rounded();
        if mantissa == 1 << 53 {
            mantissa /= 2;
            exponent += 1;
        }
        if exponent > 1024 {
            return f64::INFINITY;
        }
        let biased = if mantissa < 1 << 52 { 0 } else { (exponent + 1022) as u64 };
        f64::from_bits((biased << 52) | (mantissa & ((1 << 52) - 1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agrees(text: &str) {
        let (own, wanted) = (parse_decimal(text), text.parse::<f64>().ok());
        assert_eq!(own.map(f64::to_bits), wanted.map(f64::to_bits), "{text}: {own:?}, not {wanted:?}");
    }

    #[test]
    fn any_digits_give_the_nearest_number() {
        let mut random = fastrand::Rng::with_seed(5);
        for _ in 0..20_000 {
            let digits =
                |count: usize, random: &mut fastrand::Rng| (0..count).map(|_| random.digit(10)).collect::<String>();
            let [whole, decimals] = [random.usize(0..20), random.usize(0..25)].map(|count| digits(count, &mut random));
            let exponent = random.i32(-340..320);
            let sign = ["", "-", "+"][random.usize(0..3)];
            for text in [format!("{sign}{whole}.{decimals}"), format!("{sign}{whole}1.{decimals}e{exponent}"), whole] {
                agrees(&text);
            }
            let any = f64::from_bits(random.u64(..));
            if any.is_finite() {
                agrees(&format!("{any:e}"));
                agrees(&format!("{any:.17e}"));
            }
        }
    }

    #[test]
    fn numbers_at_an_edge_and_half_way_between_two_others() {
        for text in [
            "0",
            "-0",
            "0.0",
            "000",
            "1",
            "9007199254740993",
            "9007199254740992.5",
            "9007199254740995",
            "9007199254740993.000001",
            "1.7976931348623157e308",
            "1.7976931348623159e308",
            "1.797693134862315807e308",
            "1e309",
            "1e400",
            "4.9e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.5e-324",
            "2.2250738585072011e-308",
            "2.2250738585072014e-308",
            "1e-400",
            "1e22",
            "1e23",
            "8.5e-17",
            ".5",
            "5.",
            "1e2147483647",
            "1e-2147483647",
        ] {
            agrees(text);
        }
        let half = format!("{:.0}", 2f64.powi(1000) + 2f64.powi(947));
        agrees(&half);
        // Half way between one and the next number, and a little more than that.
        let half = format!("{:.53}", 1.0 + f64::EPSILON / 2.0);
        let half = if half.ends_with('0') {
            "1.00000000000000011102230246251565404236316680908203125".to_owned()
        } else {
            half
        };
        agrees(&half);
        agrees(&(half.clone() + &"0".repeat(900)));
        agrees(&(half + &"0".repeat(900) + "1"));
    }

    #[test]
    fn a_number_is_written_with_any_count_of_digits() {
        let written = |value: f64, decimals: usize| {
            assert_eq!(fixed(value, decimals), format!("{value:.decimals$}"), "{value:e} {decimals}");
            assert_eq!(scientific(value, decimals), format!("{value:.decimals$e}"), "{value:e} {decimals}");
        };
        let mut random = fastrand::Rng::with_seed(6);
        for _ in 0..5_000 {
            let near_one = random.f64() * f64::from(10_u32.pow(random.u32(0..9)));
            let short = f64::from(random.i32(-5000..5000)) / 16.0;
            for value in [f64::from_bits(random.u64(..)), near_one, -near_one / 1e6, short] {
                written(value, random.usize(0..18));
            }
        }
        let edges = [
            0.0,
            -0.0,
            0.5,
            1.5,
            2.5,
            -0.5,
            0.25,
            0.05,
            0.95,
            9.5,
            99.5,
            0.995,
            999.9,
            1e22,
            5e-324,
            f64::MAX,
            f64::MIN_POSITIVE,
        ];
        for value in edges.into_iter().chain([f64::INFINITY, f64::NEG_INFINITY, f64::NAN]) {
            (0..6).for_each(|decimals| written(value, decimals));
        }
    }

    #[test]
    fn other_signs_are_no_number() {
        for text in [
            "", ".", "-", "+", "e5", ".e5", "1e", "1e+", "1.2.3", "1,5", " 1", "1 ", "--1", "1e5.0", "0x10", "1_000",
            "é",
        ] {
            agrees(text);
        }
    }
}
