//! Whether the texts in a record are as long as the record has room for: its reader makes room for as many bytes as a length says before it reads
//! them, up to 4 GB.

use mcap::records::op;

/// Whether the texts of a record that is read fit into it; none of a record that is not read.
pub(super) fn texts_fit(opcode: u8, data: &[u8]) -> Option<bool> {
    let fits = match opcode {
        op::HEADER => after_texts(data, 2).is_some(),
        // Times, name and media type.
        op::ATTACHMENT => data.get(16..).and_then(|rest| after_texts(rest, 2)).is_some(),
        // Two numbers, topic and encoding, then keys and values.
        op::CHANNEL => data.get(4..).and_then(|rest| after_texts(rest, 2)).is_some_and(all_texts),
        op::MESSAGE | op::DATA_END => true,
        _ => return None,
    };
    Some(fits)
}

/// What follows so many texts, each behind its length.
fn after_texts(mut rest: &[u8], texts: usize) -> Option<&[u8]> {
    for _ in 0..texts {
        let (length, behind) = rest.split_first_chunk::<4>()?;
        rest = behind.get(u32::from_le_bytes(*length) as usize..)?;
    }
    Some(rest)
}

/// Whether a list of texts is whole, behind its length in bytes.
fn all_texts(list: &[u8]) -> bool {
    let Some((length, behind)) = list.split_first_chunk::<4>() else { return false };
    let Some(mut rest) = behind.get(..u32::from_le_bytes(*length) as usize) else { return false };
    while !rest.is_empty() {
        let Some(after) = after_texts(rest, 1) else { return false };
        rest = after;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(length: u32, bytes: &[u8]) -> Vec<u8> {
        [&length.to_le_bytes(), bytes].concat()
    }

    #[test]
    fn a_text_longer_than_its_record_is_not_read() {
        let times = [0; 16];
        let attachment = |name: u32| [&times[..], &text(name, b"scene"), &text(4, b"text"), &[0; 12]].concat();
        assert_eq!(texts_fit(op::ATTACHMENT, &attachment(5)), Some(true));
        assert_eq!(texts_fit(op::ATTACHMENT, &attachment(711_748_975)), Some(false));
        assert_eq!(texts_fit(op::ATTACHMENT, &times[..9]), Some(false));
        let channel = |topic: u32, key: u32| {
            let list = [text(key, b"key"), text(1, b"v")].concat();
            [&[1, 0, 1, 0], &text(topic, b"/state")[..], &text(4, b"json"), &text(list.len() as u32, &list)].concat()
        };
        assert_eq!(texts_fit(op::CHANNEL, &channel(6, 3)), Some(true));
        assert_eq!(texts_fit(op::CHANNEL, &channel(6, u32::MAX)), Some(false));
        assert_eq!(texts_fit(op::CHANNEL, &channel(u32::MAX, 3)), Some(false));
        assert_eq!(texts_fit(op::HEADER, &text(9, b"")), Some(false));
        assert_eq!(texts_fit(op::SCHEMA, &[]), None);
    }
}
