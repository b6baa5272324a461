//! Tables as CSV and back.

use report::{column, columns_csv, table};

#[test]
fn columns_come_back_to_the_last_bit_under_names_of_any_letters() {
    let values = vec![f64::MIN_POSITIVE, -1.0 / 3.0, 5e-324, f64::MAX, 1e22, 0.1 + 0.2, f64::INFINITY, f64::NAN];
    for name in ["plain", "with, comma", "with \"quotes\"", "of two\nlines", "\u{b5}m; \u{3c3}"] {
        let text = columns_csv(&[("s".into(), values.clone()), (name.into(), values.clone())]);
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        let read = column(&text, name).unwrap();
        assert_eq!(bits(&read[..7]), bits(&values[..7]), "{name}");
        assert!(read[7].is_nan());
    }
}

#[test]
fn only_what_must_be_is_quoted_and_lines_end_with_lf() {
    let rows = [["1", "a,b"], ["", "\"c\""]].map(|row| row.map(String::from).to_vec());
    assert_eq!(table(&["n", "a word"], rows), "n,a word\n1,\"a,b\"\n,\"\"\"c\"\"\"\n");
}

#[test]
fn a_column_that_is_not_there_or_has_a_gap_is_none() {
    let text = "a,b\n1,2\n3\n";
    assert_eq!(column(text, "a"), Some(vec![1.0, 3.0]));
    assert_eq!((column(text, "b"), column(text, "c"), column("", "a")), (None, None, None));
}
