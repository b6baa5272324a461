//! A drawing with one cubic spline and marked points, as ASCII DXF of AutoCAD 2000 (AC1015), the oldest version that has splines.

/// What is drawn, in the plane (x, z) of the scene as (x, y) of the drawing.
pub(crate) struct Drawing<'a> {
    /// Comments at the head, and texts on the layer NOTES.
    pub(crate) notes: &'a [String],
    /// Knots of the spline, the ends fourfold.
    pub(crate) knots: &'a [f64],
    /// Control points of the spline.
    pub(crate) control: &'a [[f64; 2]],
    /// Points by layer.
    pub(crate) marks: &'a [(&'static str, [f64; 2])],
}

/// Group codes and values, one a line.
struct Writer {
    text: String,
    handle: u32,
}

impl Writer {
    fn put(&mut self, code: u32, value: impl std::fmt::Display) {
        self.text += &format!("{code:>3}\n{value}\n");
    }

    fn many(&mut self, pairs: &[(u32, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    fn next_handle(&mut self) -> String {
        self.handle += 1;
        format!("{:X}", self.handle)
    }

    /// A table with its entries: name, type of the records, and what follows the name of each.
    fn table(&mut self, name: &str, class: &str, entries: &[(&str, &[(u32, &str)])]) {
        let table = self.next_handle();
        self.many(&[(0, "TABLE"), (2, name), (5, &table), (100, "AcDbSymbolTable")]);
        self.put(70, entries.len());
        if name == "DIMSTYLE" {
            self.many(&[(100, "AcDbDimStyleTable"), (71, "0")]);
        }
        for (entry, rest) in entries {
            let handle = match (name, *entry) {
                ("BLOCK_RECORD", "*Model_Space") => MODEL_SPACE.to_string(),
                ("BLOCK_RECORD", _) => PAPER_SPACE.to_string(),
                _ => self.next_handle(),
            };
            self.many(&[(0, name), (5, &handle), (330, &table), (100, "AcDbSymbolTableRecord"), (100, class), (2, entry)]);
            self.many(rest);
        }
        self.put(0, "ENDTAB");
    }

    /// The head of an entity in model space.
    fn entity(&mut self, kind: &str, layer: &str, class: &str) {
        let handle = self.next_handle();
        self.many(&[(0, kind), (5, &handle), (330, MODEL_SPACE), (100, "AcDbEntity"), (8, layer), (100, class)]);
    }

    fn point(&mut self, [x, y]: [f64; 2]) {
        self.put(10, x);
        self.put(20, y);
        self.put(30, 0);
    }
}

/// Handles that others refer to; free ones are counted from above them.
const MODEL_SPACE: &str = "1F";
const PAPER_SPACE: &str = "1B";
const FIRST_HANDLE: u32 = 0x100;

/// Text of the file.
pub(crate) fn dxf(drawing: &Drawing<'_>) -> String {
    let mut out = Writer { text: String::new(), handle: FIRST_HANDLE };
    for note in drawing.notes {
        out.put(999, ascii(note));
    }
    out.many(&[(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, "4")]);
    out.many(&[(9, "$MEASUREMENT"), (70, "1"), (9, "$HANDSEED"), (5, "FFFF"), (0, "ENDSEC")]);
    out.many(&[(0, "SECTION"), (2, "CLASSES"), (0, "ENDSEC")]);
    tables(&mut out);
    blocks(&mut out);
    out.many(&[(0, "SECTION"), (2, "ENTITIES")]);
    out.entity("SPLINE", "PROFILE", "AcDbSpline");
    // Planar; degree, numbers of knots, control points and fit points, tolerances.
    out.many(&[(210, "0"), (220, "0"), (230, "1"), (70, "8"), (71, "3")]);
    out.put(72, drawing.knots.len());
    out.put(73, drawing.control.len());
    out.many(&[(74, "0"), (42, "1e-12"), (43, "1e-12")]);
    drawing.knots.iter().for_each(|knot| out.put(40, knot));
    drawing.control.iter().for_each(|point| out.point(*point));
    for (layer, place) in drawing.marks {
        out.entity("POINT", layer, "AcDbPoint");
        out.point(*place);
    }
    // Notes below the curve, as high as fits its width.
    let range = |k: usize| {
        let values = drawing.control.iter().map(|point| point[k]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
    };
    let ([left, right], [low, _]) = (range(0), range(1));
    let height = (right - left) / 80.0;
    for (row, note) in drawing.notes.iter().enumerate() {
        out.entity("TEXT", "NOTES", "AcDbText");
        out.point([left, low - 2.0 * height * (row + 2) as f64]);
        out.put(40, height);
        out.put(1, ascii(note));
        out.put(100, "AcDbText");
    }
    out.put(0, "ENDSEC");
    let (root, group) = (out.next_handle(), out.next_handle());
    out.many(&[(0, "SECTION"), (2, "OBJECTS"), (0, "DICTIONARY"), (5, &root), (330, "0"), (100, "AcDbDictionary"), (281, "1")]);
    out.many(&[
        (3, "ACAD_GROUP"),
        (350, &group),
        (0, "DICTIONARY"),
        (5, &group),
        (330, &root),
        (100, "AcDbDictionary"),
        (281, "1"),
    ]);
    out.many(&[(0, "ENDSEC"), (0, "EOF")]);
    out.text
}

fn tables(out: &mut Writer) {
    out.many(&[(0, "SECTION"), (2, "TABLES")]);
    let port: &[(u32, &str)] = &[
        (70, "0"),
        (10, "0"),
        (20, "0"),
        (11, "1"),
        (21, "1"),
        (12, "0"),
        (22, "0"),
        (16, "0"),
        (26, "0"),
        (36, "1"),
        (40, "300"),
        (41, "1"),
    ];
    out.table("VPORT", "AcDbViewportTableRecord", &[("*Active", port)]);
    let line: &[(u32, &str)] = &[(70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0")];
    out.table("LTYPE", "AcDbLinetypeTableRecord", &[("ByBlock", line), ("ByLayer", line), ("Continuous", line)]);
    let layer = |colour: &'static str| [(70, "0"), (62, colour), (6, "Continuous")];
    let (black, red, blue, green) = (layer("7"), layer("1"), layer("5"), layer("3"));
    let layers: &[(&str, &[(u32, &str)])] =
        &[("0", &black), ("PROFILE", &black), ("DATUM", &red), ("MOST-TAKEN-OFF", &blue), ("NOTES", &green)];
    out.table("LAYER", "AcDbLayerTableRecord", layers);
    let style: &[(u32, &str)] = &[(70, "0"), (40, "0"), (41, "1"), (50, "0"), (71, "0"), (42, "2.5"), (3, "txt"), (4, "")];
    out.table("STYLE", "AcDbTextStyleTableRecord", &[("Standard", style)]);
    out.table("VIEW", "AcDbViewTableRecord", &[]);
    out.table("UCS", "AcDbUCSTableRecord", &[]);
    out.table("APPID", "AcDbRegAppTableRecord", &[("ACAD", &[(70, "0")])]);
    out.table("DIMSTYLE", "AcDbDimStyleTableRecord", &[]);
    out.table("BLOCK_RECORD", "AcDbBlockTableRecord", &[("*Model_Space", &[]), ("*Paper_Space", &[])]);
    out.put(0, "ENDSEC");
}

fn blocks(out: &mut Writer) {
    out.many(&[(0, "SECTION"), (2, "BLOCKS")]);
    for (name, owner) in [("*Model_Space", MODEL_SPACE), ("*Paper_Space", PAPER_SPACE)] {
        let (begin, end) = (out.next_handle(), out.next_handle());
        out.many(&[
            (0, "BLOCK"),
            (5, &begin),
            (330, owner),
            (100, "AcDbEntity"),
            (8, "0"),
            (100, "AcDbBlockBegin"),
            (2, name),
            (70, "0"),
        ]);
        out.many(&[(10, "0"), (20, "0"), (30, "0"), (3, name), (1, "")]);
        out.many(&[(0, "ENDBLK"), (5, &end), (330, owner), (100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")]);
    }
    out.put(0, "ENDSEC");
}

/// One line of ASCII; other letters in the notation of DXF.
fn ascii(text: &str) -> String {
    let letter = |c: char| if c.is_ascii() && !c.is_control() { c.to_string() } else { format!("\\U+{:04X}", u32::from(c)) };
    text.chars().map(letter).collect()
}
