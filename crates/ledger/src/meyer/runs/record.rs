//! The verdicts on record that are not `reproduced`, and the fingerprints of the rows.

use super::*;

/// Rows by the line of the source's text.
type Lines = &'static [u32];

/// The verdicts on record.
const RECORD: &[(Verdict, Column, Lines)] = &[
    (Verdict::ReadOff, Column::Peak, &[807, 808, 813, 821]),
    (Verdict::ReadOff, Column::Minimum, &[784, 788, 795, 796, 797]),
    (Verdict::ReadOff, Column::Rise, &[818, 819]),
    (Verdict::ReadOff, Column::Period, &[806, 814, 815, 834, 838, 840, 842]),
    (
        Verdict::ReproducedInError,
        Column::Peak,
        &[
            784, 785, 786, 787, 788, 789, 790, 791, 792, 793, 794, 795, 796, 797, 798, 799, 817, 828, 829, 830, 831,
            832, 833, 834, 835, 836, 837, 838, 839, 840, 841, 842, 843,
        ],
    ),
    (
        Verdict::ReproducedInError,
        Column::Minimum,
        &[
            785, 786, 787, 789, 790, 791, 793, 794, 798, 799, 828, 829, 830, 831, 832, 833, 834, 835, 836, 837, 838,
            839, 840, 841, 842, 843,
        ],
    ),
    (
        Verdict::ReproducedInError,
        Column::Period,
        &[
            784, 785, 786, 787, 788, 789, 790, 791, 792, 793, 794, 795, 796, 797, 798, 799, 828, 829, 830, 831, 832,
            833, 835, 841, 843,
        ],
    ),
    (Verdict::NotReproduced, Column::Peak, &[815, 822]),
    (
        Verdict::NotReproduced,
        Column::Rise,
        &[
            784, 785, 786, 787, 788, 789, 790, 791, 792, 793, 794, 795, 796, 797, 798, 799, 806, 807, 808, 809, 810,
            811, 812, 813, 814, 815, 816, 817, 828, 829, 830, 831, 832, 833, 834, 835, 836, 837, 838, 839, 840, 841,
            842, 843,
        ],
    ),
    (Verdict::Corrected, Column::Rise, &[822]),
];

/// The verdict on record.
pub fn verdict(row: &Row, column: Column) -> Verdict {
    let listed = RECORD.iter().find(|(_, of, lines)| *of == column && lines.contains(&row.line));
    listed.map_or(Verdict::Reproduced, |(verdict, ..)| *verdict)
}

/// The fingerprint on record of a row's line; zero for a line that is no row.
pub fn fingerprint(line: u32) -> u64 {
    FINGERPRINTS.iter().find(|(number, _)| *number == line).map_or(0, |(_, fingerprint)| *fingerprint)
}

const FINGERPRINTS: [(u32, u64); 49] = [
    (784, 0x6329_a2df_e19f_2ea0),
    (785, 0x15c2_5f93_6914_7c32),
    (786, 0x3b62_e16e_9a16_3b26),
    (787, 0x3c82_e840_504e_724e),
    (788, 0x8dff_1d3f_a127_bbcb),
    (789, 0xe00e_10fa_78fa_c8b3),
    (790, 0x48df_5d5c_3c23_449d),
    (791, 0x4ab8_cd84_6771_ef62),
    (792, 0x99fa_0175_4770_7556),
    (793, 0x26dd_2c9a_96e9_85c4),
    (794, 0x8b72_33aa_5b05_d64c),
    (795, 0x7acb_ccee_488a_a255),
    (796, 0x66ad_57a4_fa7f_c197),
    (797, 0xa38b_ce43_0c3f_bb6f),
    (798, 0x4ddd_a778_bd31_b83b),
    (799, 0x29a6_dda7_1a8e_bb0e),
    (806, 0xe820_8220_5e80_5861),
    (807, 0xe84c_88af_78cd_f628),
    (808, 0x6deb_5844_c313_9285),
    (809, 0x40d0_129d_b0b1_83d1),
    (810, 0x5f25_d6fa_c718_64db),
    (811, 0x8cc7_37b5_b440_6415),
    (812, 0x7295_7bfd_2f29_d4f0),
    (813, 0xe166_ceba_4180_a14d),
    (814, 0xd6c6_8e23_cc96_1a17),
    (815, 0x8655_b587_9cbb_5d06),
    (816, 0x25a0_1ae0_87e2_67fe),
    (817, 0xc83e_d72f_d05a_2d44),
    (818, 0x62bc_975c_f9df_44cb),
    (819, 0x7a17_5cee_cf36_d91e),
    (820, 0x7fef_f9a7_fc11_c8d1),
    (821, 0x9c5d_3b66_9822_4bab),
    (822, 0x7cf1_a5e3_64f4_3214),
    (828, 0xe516_f89a_c32a_c30a),
    (829, 0x7db5_6e84_3195_ca38),
    (830, 0xa3b5_5b4c_58fb_8e1c),
    (831, 0xbb7d_e399_ad20_7e09),
    (832, 0xa867_bf53_ad7d_94b7),
    (833, 0x1cdf_ee53_3754_5676),
    (834, 0xbc85_9316_3f48_8edb),
    (835, 0xf9e6_a196_b30e_6324),
    (836, 0x76f6_6222_3f4e_78cb),
    (837, 0x8a4a_95a0_4713_077d),
    (838, 0x40d7_d265_d66c_016e),
    (839, 0x69ee_f4dd_d04a_e133),
    (840, 0x9dc7_8b65_4c5f_bbe9),
    (841, 0x5102_3cd0_f201_a0ac),
    (842, 0x415a_b334_daf5_3bc3),
    (843, 0x739c_edd7_2c6c_780d),
];
