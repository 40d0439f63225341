//! Any program ends: at its end, at a fault with a place in the program, or at a limit; every position is a number.
#![no_main]
use std::sync::OnceLock;

use ciklo::base::data;
use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Limits, NoTexts};
use ciklo::engine::scene::Scene;
use ciklo::spec::Catalogue;
use ciklo::program::syntax::parse;
use libfuzzer_sys::fuzz_target;

const LIMITS: Limits = Limits { blocks: 2_000, jumps: 200, depth: 19, members: 200, moves: 20_000 };

fuzz_target!(|text: &str| {
    static DATA: OnceLock<(Catalogue, Scene)> = OnceLock::new();
    let (catalogue, scene) = DATA.get_or_init(|| {
        let files = data::embedded();
        let scene = include_str!("../../examples/hole.scene.yaml");
        (Catalogue::load(&files).0, Scene::parse(&Source::new("hole.scene.yaml", scene), &files).expect("a scene"))
    });
    let program = parse(&Source::new("fuzz.h", text));
    for on in catalogue.controls.values() {
        let engine = Engine::new(&program, on, scene, &NoTexts).with_catalogue(catalogue).with_limits(LIMITS);
        let outcome = engine.run(&mut |_| ());
        assert!(outcome.position.is_finite() && outcome.angles.is_finite());
        assert_eq!(outcome.fault.is_some(), outcome.diagnostic.is_some());
        if let Some(place) = outcome.diagnostic.and_then(|diagnostic| diagnostic.place) {
            assert!(place.source.text().get(place.span.start..place.span.end).is_some());
        }
    }
});
