//! Reading charts, for the tests that draw them.

use roxmltree::{Document, Node};
use stribeck_charts::{Chart, MARK, Paper};

/// All text of a picture, each text trimmed.
pub fn texts(document: &Document) -> Vec<String> {
    document
        .descendants()
        .filter(|n| n.has_tag_name("text"))
        .map(|n| n.descendants().filter(|part| part.is_text()).filter_map(|part| part.text()).collect())
        .map(|text: String| text.trim().to_string())
        .collect()
}

/// The elements with these attributes.
pub fn with<'a>(document: &'a Document, attributes: &'a [(&str, &str)]) -> impl Iterator<Item = Node<'a, 'a>> {
    document.descendants().filter(|node| attributes.iter().all(|(name, value)| node.attribute(*name) == Some(*value)))
}

/// A number that stands in an attribute.
pub fn number(node: &Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// Width and height of a PNG, which is decoded to its end.
fn decoded(bytes: &[u8]) -> (u32, u32) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut pixels).unwrap();
    assert!(pixels.iter().any(|place| *place != pixels[0]), "the picture is empty");
    (frame.width, frame.height)
}

/// All formats of a chart are well formed, of one shape, known by their beginning, and the same when drawn again.
pub fn check_formats(chart: &impl Chart) -> String {
    let paper = Paper::default();
    let text = chart.svg(&paper).unwrap();
    let document = Document::parse(&text).unwrap();
    let root = document.root_element();
    let (width, height) = (number(&root, "width"), number(&root, "height"));
    assert_eq!(width, paper.width);
    let bytes = chart.png(&paper).unwrap();
    let (across, down) = decoded(&bytes);
    assert_eq!(across, paper.pixels);
    assert!((height / width - f64::from(down) / f64::from(across)).abs() < 1e-3, "{width} {height} {across} {down}");
    let page = chart.pdf(&paper).unwrap();
    assert!(page.starts_with(b"%PDF-1.") && page.ends_with(b"%%EOF"));
    for beginning in [text.as_bytes(), &bytes, &page].map(|file| &file[..1000]) {
        assert!(beginning.windows(MARK.len()).any(|word| word == MARK.as_bytes()));
    }
    assert_eq!(chart.svg(&paper).unwrap(), text);
    assert_eq!(chart.png(&paper).unwrap(), bytes);
    assert_eq!(chart.pdf(&paper).unwrap(), page);
    text
}

/// The points of a polygon or polyline.
pub fn points(node: &Node) -> Vec<(f64, f64)> {
    let pair = |point: &str| {
        let (x, y) = point.split_once(',').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    };
    node.attribute("points").unwrap().split_whitespace().map(pair).collect()
}

/// The polygons, but for the walls behind a surface in space.
pub fn polygons<'a>(document: &'a Document) -> impl Iterator<Item = Node<'a, 'a>> {
    const WALL: &str = "#F7F7F7";
    document.descendants().filter(|node| node.has_tag_name("polygon") && node.attribute("fill") != Some(WALL))
}
