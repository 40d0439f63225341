//! Triangulated surfaces: read from STL files, touched by balls. Expected contacts are those of school geometry, or those
//! of the same solid without triangles, whose contacts have tests of their own.
use std::collections::BTreeMap;
use std::sync::Arc;

use ciklo::base::data::embedded;
use ciklo::base::diag::{Diagnostic, Source};
use ciklo::engine::geometry::{Axis, Frame};
use ciklo::engine::scene::{Beside, Scene};
use ciklo::engine::solid::{Body, Contact, Mesh, Path, Shape, SolidError};
use glam::{DVec3, dvec3};
use proptest::prelude::*;

/// Files in memory.
#[derive(Default)]
struct Memory(BTreeMap<String, Vec<u8>>);

impl Beside for Memory {
    fn size(&self, name: &str) -> Option<u64> {
        self.0.get(name).map(|bytes| bytes.len() as u64)
    }

    fn bytes(&self, name: &str) -> Result<Vec<u8>, Diagnostic> {
        self.0.get(name).cloned().ok_or_else(|| Diagnostic::global("io-read"))
    }
}

/// A file that says to be larger than it may be.
struct Huge;

impl Beside for Huge {
    fn size(&self, _: &str) -> Option<u64> {
        Some(u64::MAX)
    }

    fn bytes(&self, _: &str) -> Result<Vec<u8>, Diagnostic> {
        panic!("it must not be read")
    }
}

/// The twelve triangles of a box; normals and order do not matter.
fn box_triangles(min: DVec3, max: DVec3) -> Vec<[DVec3; 3]> {
    let corner = |k: usize| {
        let pick = |bit: usize, low: f64, high: f64| if k & bit == 0 { low } else { high };
        dvec3(pick(1, min.x, max.x), pick(2, min.y, max.y), pick(4, min.z, max.z))
    };
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).map(|three| three.map(corner)).collect()
}

/// Each triangle in four, as often as `times` says.
fn finer(triangles: Vec<[DVec3; 3]>, times: usize) -> Vec<[DVec3; 3]> {
    (0..times).fold(triangles, |all, _| {
        let four = |[a, b, c]: [DVec3; 3]| {
            let (ab, bc, ca) = (a.midpoint(b), b.midpoint(c), c.midpoint(a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        all.into_iter().flat_map(four).collect()
    })
}

fn text(triangles: &[[DVec3; 3]]) -> String {
    let vertex = |p: &DVec3| format!("      vertex {} {} {}\n", p.x, p.y, p.z);
    let facet = |three: &[DVec3; 3]| {
        let corners: String = three.iter().map(vertex).collect();
        format!("  facet normal 0 0 0\n    outer loop\n{corners}    endloop\n  endfacet\n")
    };
    format!("solid part of a test\n{}endsolid part of a test\n", triangles.iter().map(facet).collect::<String>())
}

fn binary(triangles: &[[DVec3; 3]]) -> Vec<u8> {
    // The head may begin like a text.
    let mut bytes = vec![b' '; 80];
    bytes[..5].copy_from_slice(b"solid");
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for three in triangles {
        let numbers = [DVec3::ZERO].iter().chain(three).flat_map(|p| p.to_array()).collect::<Vec<_>>();
        bytes.extend(numbers.iter().flat_map(|number| (*number as f32).to_le_bytes()));
        bytes.extend([0, 0]);
    }
    bytes
}

fn read(scene: &str, files: &[(&str, Vec<u8>)]) -> Result<Scene, Vec<Diagnostic>> {
    let memory = Memory(files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.clone())).collect());
    Scene::parse_beside(&Source::new("test.scene.yaml", scene), &embedded(), Some(&memory))
}

const PART: &str = "scene: 1\nparts: [{place: {shift: [100, 0, 0], rotate: [0, 0, 90]}, solid: {stl: part.stl}}]\n";

fn mesh(triangles: &[[DVec3; 3]]) -> Shape {
    Shape::Mesh(Arc::new(Mesh::new(triangles).expect("a surface")))
}

fn touch(body: &Body, radius: f64, from: [f64; 3], to: [f64; 3]) -> Option<Contact> {
    body.first_contact(radius, DVec3::from(from), DVec3::from(to)).expect("an answer")
}

#[track_caller]
fn assert_near(found: Option<Contact>, centre: [f64; 3]) {
    let found = found.expect("a contact");
    assert!((found.ball_centre - DVec3::from(centre)).length() < 1e-9, "{found:?} instead of {centre:?}");
    assert!(!found.deflected);
}

#[test]
fn binary_files_and_texts_are_the_same_part() {
    let triangles = box_triangles(dvec3(0.0, 0.0, -10.0), dvec3(30.0, 20.0, 0.0));
    let twice = text(&triangles[..6]) + &text(&triangles[6..]).to_uppercase().replace('\n', "\r\n");
    for bytes in [binary(&triangles), text(&triangles).into_bytes(), twice.into_bytes()] {
        let scene = read(PART, &[("part.stl", bytes)]).expect("a sound scene");
        // Turned by a quarter the part reaches from X 80 to 100 and from Y 0 to 30.
        assert_near(touch(&scene.body, 2.0, [90.0, 10.0, 50.0], [90.0, 10.0, -50.0]), [90.0, 10.0, 2.0]);
        assert_near(touch(&scene.body, 2.0, [50.0, 10.0, -5.0], [90.0, 10.0, -5.0]), [78.0, 10.0, -5.0]);
        // Above the edge by 1.2 with a radius of 2: 80 - sqrt(2² - 1.2²).
        assert_near(touch(&scene.body, 2.0, [50.0, 10.0, 1.2], [90.0, 10.0, 1.2]), [78.4, 10.0, 1.2]);
        assert_eq!(scene.body.contains(dvec3(81.0, 29.0, -9.0)), Ok(true));
        assert_eq!(scene.body.contains(dvec3(79.0, 29.0, -9.0)), Ok(false));
        // The way of a line through it.
        assert_eq!(scene.body.along(dvec3(90.0, 10.0, 0.0), DVec3::Z), Ok(vec![[-10.0, 0.0]]));
    }
}

#[test]
fn lengths_are_in_the_unit_of_the_scene() {
    let triangles = box_triangles(DVec3::ZERO, DVec3::ONE);
    let scene = "scene: 1\nunits: inch\nparts: [{solid: {stl: part.stl}}]\n";
    let scene = read(scene, &[("part.stl", binary(&triangles))]).expect("a sound scene");
    assert_near(touch(&scene.body, 1.0, [5.0, 5.0, 50.0], [5.0, 5.0, 0.0]), [5.0, 5.0, 26.4]);
}

#[test]
fn a_surface_stands_beside_other_solids() {
    let scene = "scene: 1\nparts: [{solid: {union: [{stl: part.stl}, {box: {min: [-50, -50, -20], max: [50, 50, 0]}}]}}, \
                 {place: {shift: [0, 100, 0]}, solid: {stl: part.stl}}]\n";
    // A pyramid of height 10 over a square of 20.
    let [a, b, c, d] = [[-10.0, -10.0], [10.0, -10.0], [10.0, 10.0], [-10.0, 10.0]].map(|[x, y]| dvec3(x, y, 0.0));
    let tip = dvec3(0.0, 0.0, 10.0);
    let pyramid = [[a, b, tip], [b, c, tip], [c, d, tip], [d, a, tip], [a, b, c], [a, c, d]];
    let scene = read(scene, &[("part.stl", binary(&pyramid))]).expect("a sound scene");
    for y in [0.0, 100.0] {
        // The tip, and its face at 45 degrees, 1 away from a ball over X 5.
        assert_near(touch(&scene.body, 1.0, [0.0, y, 50.0], [0.0, y, 0.0]), [0.0, y, 11.0]);
        assert_near(touch(&scene.body, 1.0, [5.0, y, 50.0], [5.0, y, 0.0]), [5.0, y, 5.0 + 2.0_f64.sqrt()]);
    }
    // The top of the box beside it.
    assert_near(touch(&scene.body, 1.0, [30.0, 0.0, 50.0], [30.0, 0.0, 0.0]), [30.0, 0.0, 1.0]);
    // In the corner between them the ball lies on the box and touches the pyramid: 10 + sqrt 2 - 1.
    assert_near(touch(&scene.body, 1.0, [30.0, 0.0, 1.0], [0.0, 0.0, 1.0]), [9.0 + 2.0_f64.sqrt(), 0.0, 1.0]);
}

#[test]
fn a_surface_that_is_not_closed_has_two_sides_and_no_inside() {
    let all = box_triangles(DVec3::ZERO, DVec3::splat(10.0));
    let (closed, open) = (Mesh::new(&all).expect("a box"), Mesh::new(&all[1..]).expect("most of a box"));
    assert!(closed.is_closed() && !open.is_closed());
    assert_eq!((closed.len(), open.len()), (12, 11));
    let (solid, skin) = (Body::new(&mesh(&all)).expect("a body"), Body::new(&mesh(&all[1..])).expect("a body"));
    let middle = DVec3::splat(5.0);
    assert_eq!((solid.contains(middle), skin.contains(middle)), (Ok(true), Ok(false)));
    // From within, the wall of the skin is touched from its other side.
    assert_near(touch(&skin, 1.0, [5.0, 5.0, 5.0], [20.0, 5.0, 5.0]), [9.0, 5.0, 5.0]);
    assert!(touch(&solid, 1.0, [5.0, 5.0, 5.0], [20.0, 5.0, 5.0]).is_some_and(|contact| contact.deflected));
    assert_eq!(skin.contains(dvec3(10.0, 4.0, 3.0)), Ok(true));
}

#[test]
fn triangles_without_an_area_are_passed_over() {
    let mut all = box_triangles(DVec3::ZERO, DVec3::splat(10.0));
    let [a, b, c] = all[0];
    all.extend([[a, a, b], [a, b, a], [a.midpoint(c); 3]]);
    let mesh = Mesh::new(&all).expect("a box");
    assert!(mesh.is_closed() && mesh.len() == 12);
    assert!(Mesh::new(&[[a, b, a.midpoint(b)]]).is_none() && Mesh::new(&[]).is_none());
}

#[test]
fn surfaces_are_not_cut() {
    let all = mesh(&box_triangles(DVec3::ZERO, DVec3::splat(10.0)));
    let hole = Shape::Sphere { centre: DVec3::ZERO, radius: 5.0 };
    for pair in [vec![all.clone(), hole.clone()], vec![hole, Shape::Union(vec![all])]] {
        assert_eq!(Body::new(&Shape::Difference(pair)).err(), Some(SolidError::CutMesh));
    }
}

/// Each wrong file, with the code of what is found and its place.
#[test]
fn every_mistake_of_a_file_has_its_place() {
    let good = box_triangles(DVec3::ZERO, DVec3::splat(10.0));
    let (sound, whole) = (text(&good), binary(&good));
    let mut not_a_number = whole.clone();
    not_a_number[84 + 50 * 4 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    let mut countless = whole.clone();
    countless[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    countless[0] = 0;
    let changed = |from: &str, to: &str| sound.replacen(from, to, 1).into_bytes();
    let cases: Vec<(Vec<u8>, &str, usize, usize)> = vec![
        (not_a_number, "number 5", 2, 23),
        (countless, "length 4294967295", 2, 23),
        (whole[..whole.len() - 1].to_vec(), "length 12", 2, 23),
        (Vec::new(), "scene-stl-word", 1, 1),
        (b"solid nothing\nendsolid\n".to_vec(), "empty 0", 2, 23),
        (changed("vertex", "vertix"), "scene-stl-word", 4, 7),
        (changed("vertex 0", "vertex x"), "scene-stl-word", 4, 14),
        (changed("vertex 0", "vertex 1e7"), "scene-stl-word", 4, 14),
        (changed("vertex 0", "vertex inf"), "scene-stl-word", 4, 14),
        (changed("endsolid", "solid"), "scene-stl-word", 86, 1),
        (sound.as_bytes()[..sound.len() / 2].to_vec(), "scene-stl-word", 44, 3),
        (format!("{sound}x").into_bytes(), "scene-stl-word", 87, 1),
        (b"solid \xff\xfe\nfacet normal \xff 0 0 outer loop vertex \xff".to_vec(), "scene-stl-word", 2, 38),
    ];
    let scene = "scene: 1\nparts: [{solid: {stl: part.stl}}]\n";
    for (number, (bytes, wanted, line, column)) in cases.into_iter().enumerate() {
        let found = read(scene, &[("part.stl", bytes)]).expect_err("a mistake");
        let [one] = found.as_slice() else { panic!("{number}: {found:?}") };
        let place = one.place.as_ref().expect("a place").start();
        let named = |name: &str| one.args.iter().find(|(known, _)| *known == name).map(|(_, arg)| format!("{arg:?}"));
        let kind = match (named("kind"), named("triangle")) {
            (Some(kind), Some(triangle)) => format!("{kind} {triangle}"),
            _ => one.code.to_owned(),
        };
        let kind = kind.replace("Text(\"", "").replace("\")", "").replace("Number(", "").replace(".0)", "");
        assert_eq!((kind.as_str(), place.line, place.column), (wanted, line, column), "{number}: {one:?}");
    }
    let place = |found: Vec<Diagnostic>| {
        let one = found.first().expect("a finding");
        (one.code, one.place.as_ref().map(|place| (place.start().line, place.start().column)))
    };
    assert_eq!(place(read(scene, &[]).expect_err("no file")), ("io-read", Some((2, 23))));
    let source = Source::new("test.scene.yaml", scene);
    let huge = Scene::parse_beside(&source, &embedded(), Some(&Huge)).expect_err("too large");
    assert_eq!(place(huge), ("scene-stl", Some((2, 23))));
    assert_eq!(place(Scene::parse(&source, &embedded()).expect_err("nothing beside")), ("scene-stl", Some((2, 23))));
    let cut = "scene: 1\nparts:\n- solid: {difference: [{box: {min: [0, 0, 0], max: [1, 1, 1]}}, {union: [{stl: part.stl}]}]}\n";
    assert_eq!(place(read(cut, &[("part.stl", whole)]).expect_err("a cut")), ("solid-mesh-cut", Some((3, 65))));
}

fn coordinate(low: i32, high: i32) -> impl Strategy<Value = f64> {
    (low * 4..=high * 4).prop_map(|k| f64::from(k) / 4.0)
}

fn point(reach: i32) -> impl Strategy<Value = DVec3> {
    (coordinate(-reach, reach), coordinate(-reach, reach), coordinate(-reach, reach))
        .prop_map(|(x, y, z)| dvec3(x, y, z))
}

/// Boxes turned about: as solids and as triangles.
fn boxes() -> impl Strategy<Value = (Shape, Shape)> {
    let one = (point(8), coordinate(2, 14), coordinate(2, 14), coordinate(2, 14), point(4), point(90), 0..4_usize);
    let one = one.prop_map(|(min, x, y, z, shift, rotate, times)| {
        let (max, frame) = (min + dvec3(x, y, z), Frame::placed(shift, rotate));
        let placed = |shape| Shape::Placed { frame, shape: Box::new(shape) };
        (placed(Shape::Box { min, max }), placed(mesh(&finer(box_triangles(min, max), times))))
    });
    prop::collection::vec(one, 1..3).prop_map(|all| {
        let (solid, triangles) = all.into_iter().unzip();
        (Shape::Union(solid), Shape::Union(triangles))
    })
}

fn path() -> impl Strategy<Value = Path> {
    prop_oneof![
        (point(30), point(12)).prop_map(|(from, to)| Path::line(from, to)),
        (point(12), 0..3_usize, point(30), coordinate(-400, 400)).prop_map(|(centre, axis, from, sweep)| Path::Arc {
            centre,
            axis: Axis::ALL[axis].unit(),
            from,
            sweep,
            rise: 0.0
        }),
    ]
}

laws! {
    #![proptest_config(crate::cases::config(300))]

    #[test]
    fn a_box_of_triangles_is_touched_as_a_box((solid, triangles) in boxes(), path in path(), radius in coordinate(1, 6)) {
        let (solid, triangles) = (Body::new(&solid).expect("a body"), Body::new(&triangles).expect("a body"));
        let start = path.at(0.0);
        prop_assert_eq!(solid.contains(start).expect("known"), triangles.contains(start).expect("known"));
        let (near, same) = (solid.nearest(start).expect("known"), triangles.nearest(start).expect("known"));
        let (near, same) = (near.expect("something"), same.expect("something"));
        prop_assert!((near.distance - same.distance).abs() < 1e-9, "{:?} {:?}", near, same);
        let (wanted, found) = (solid.first_contact_on(radius, &path), triangles.first_contact_on(radius, &path));
        let (wanted, found) = (wanted.expect("an answer"), found.expect("an answer"));
        let grazes = |contact: &Contact| {
            let way = (path.at(contact.t + 1e-6) - path.at(contact.t - 1e-6)).normalize_or_zero();
            way.dot(contact.normal).abs() < 1e-3
        };
        match (wanted, found) {
            (None, None) => {}
            (Some(one), Some(other)) => {
                prop_assert_eq!(one.deflected, other.deflected);
                let off = (one.ball_centre - other.ball_centre).length();
                prop_assert!(off < 1e-8 || grazes(&one) || grazes(&other), "{:?} {:?}", one, other);
                let gap = (other.ball_centre - other.point).length() - radius;
                prop_assert!(other.deflected || gap.abs() < 1e-9);
            }
            (Some(one), None) | (None, Some(one)) => prop_assert!(grazes(&one), "{:?} {:?}", wanted, found),
        }
        for direction in [DVec3::X, dvec3(0.3, -0.4, 0.866).normalize()] {
            let length = |body: &Body| body.along(start, direction).expect("known").iter().map(|[low, high]| high - low).sum::<f64>();
            prop_assert!((length(&solid) - length(&triangles)).abs() < 1e-7);
        }
    }
}
