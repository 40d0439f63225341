//! Which cases a law tries, and how many.
//!
//! `cargo test` draws the same cases everywhere, from one fixed seed, and writes nothing. A search for new ones is a
//! command of its own: `CIKLO_SEARCH=1 CIKLO_CASES=2000 cargo test --release --test laws` draws from a new seed, which a
//! failure prints, and `CIKLO_SEARCH=SEED` draws the same cases again. What a search finds becomes a test by name.
use std::collections::hash_map::RandomState;
use std::env;
use std::hash::BuildHasher as _;

use proptest::test_runner::{Config, RngSeed};

/// The seed of every law unless new cases are searched for.
const SEED: u64 = 20_140_701;

/// `usual` cases from the fixed seed, or as many as `CIKLO_CASES` says, from the seed that `CIKLO_SEARCH` asks for.
pub(crate) fn config(usual: u32) -> Config {
    let cases = env::var("CIKLO_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(usual);
    let rng_seed = RngSeed::Fixed(seed());
    Config { cases, rng_seed, failure_persistence: None, max_global_rejects: 100_000, ..Config::default() }
}

fn seed() -> u64 {
    let Ok(search) = env::var("CIKLO_SEARCH") else {
        return SEED;
    };
    match search.parse() {
        Ok(seed) if seed > 1 => seed,
        _ => {
            let seed = RandomState::new().hash_one(env::args().next());
            // Shown with the failure of the test.
            println!("CIKLO_SEARCH={seed} draws these cases again");
            seed
        }
    }
}
