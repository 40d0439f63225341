//! Values that are made when they are first asked for, and kept.
//!
//! Invariant: whoever reads a value cannot tell whether it was there before or was made for them. Making one value may
//! ask for others, but never for itself.
use std::any::{Any, TypeId};
use std::borrow::Borrow;
use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::hash::Hash;
use std::ops::Deref;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

type Maker<T> = Arc<dyn Fn() -> T + Send + Sync>;
type MakerOf<K, V> = Arc<dyn Fn(&K) -> Option<V> + Send + Sync>;

/// One value.
#[derive(Clone)]
pub struct Deferred<T> {
    cell: OnceLock<T>,
    make: Option<Maker<T>>,
}

impl<T> Deferred<T> {
    /// A value that is made by this when it is first read.
    pub fn new(make: impl Fn() -> T + Send + Sync + 'static) -> Self {
        Self { cell: OnceLock::new(), make: Some(Arc::new(make)) }
    }
}

impl<T> From<T> for Deferred<T> {
    fn from(value: T) -> Self {
        Self { cell: OnceLock::from(value), make: None }
    }
}

impl<T: Default> Default for Deferred<T> {
    fn default() -> Self {
        T::default().into()
    }
}

impl<T: Default> Deref for Deferred<T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.cell.get_or_init(|| self.make.as_ref().map_or_else(T::default, |make| make()))
    }
}

impl<T: Default + fmt::Debug> fmt::Debug for Deferred<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// A map that knows its keys from the start.
#[derive(Clone)]
pub struct OnDemand<K, V> {
    cells: BTreeMap<K, OnceLock<Option<Box<V>>>>,
    make: Option<MakerOf<K, V>>,
}

impl<K, V> Default for OnDemand<K, V> {
    fn default() -> Self {
        Self { cells: BTreeMap::new(), make: None }
    }
}

impl<K: Ord, V> FromIterator<(K, V)> for OnDemand<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let cells = entries.into_iter().map(|(key, value)| (key, OnceLock::from(Some(Box::new(value)))));
        Self { cells: cells.collect(), make: None }
    }
}

impl<K: Ord, V> OnDemand<K, V> {
    /// A map with these keys whose values are made by `make`. A key of which nothing can be made has no value.
    pub fn new(keys: impl IntoIterator<Item = K>, make: impl Fn(&K) -> Option<V> + Send + Sync + 'static) -> Self {
        let cells = keys.into_iter().map(|key| (key, OnceLock::new())).collect();
        Self { cells, make: Some(Arc::new(make)) }
    }

    /// The value of a key.
    pub fn get<Q: Ord + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        let (key, cell) = self.cells.get_key_value(key)?;
        self.value(key, cell)
    }

    fn value<'c>(&'c self, key: &K, cell: &'c OnceLock<Option<Box<V>>>) -> Option<&'c V> {
        cell.get_or_init(|| self.make.as_ref().and_then(|make| make(key)).map(Box::new)).as_deref()
    }

    /// The value of a key, to be changed.
    pub fn get_mut<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        self.get(key)?;
        self.cells.get_mut(key)?.get_mut()?.as_deref_mut()
    }

    /// All values, in the order of their keys, to be changed.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut V> {
        self.iter().for_each(drop);
        self.cells.values_mut().filter_map(|cell| cell.get_mut()?.as_deref_mut())
    }

    /// Adds a value; gives the one that the key had.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        let cell = OnceLock::from(Some(Box::new(value)));
        self.cells.insert(key, cell).and_then(OnceLock::into_inner).flatten().map(|value| *value)
    }

    /// Whether there is such a key.
    pub fn contains_key<Q: Ord + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.cells.contains_key(key)
    }

    /// The keys, in order. No value is made.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &K> + Clone {
        self.cells.keys()
    }

    /// The keys whose values were made, in order.
    pub fn made(&self) -> impl Iterator<Item = &K> {
        self.cells.iter().filter(|(_, cell)| cell.get().is_some()).map(|(key, _)| key)
    }

    /// All values, in the order of their keys.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &V> + Clone {
        self.iter().map(|(_, value)| value)
    }

    /// All keys with their values, in order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&K, &V)> + Clone {
        self.cells.iter().filter_map(|(key, cell)| Some((key, self.value(key, cell)?)))
    }

    /// How many keys there are.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }
}

impl<K: Ord + fmt::Debug, V: fmt::Debug> fmt::Debug for OnDemand<K, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.iter()).finish()
    }
}

/// What is made of values once and kept beside them, by type and by key. A copy begins without anything, so that what is
/// changed in it is not answered with what was made before.
pub struct Made<K>(Mutex<HashMap<(TypeId, K), Arc<dyn Any + Send + Sync>>>);

impl<K> Default for Made<K> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K> Clone for Made<K> {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl<K> fmt::Debug for Made<K> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("Made")
    }
}

impl<K: Eq + Hash> Made<K> {
    /// What was made of a key, or is made now. Two threads that ask at the same time may both make it; one of them is kept.
    pub fn get_or<T: Any + Send + Sync>(&self, key: K, make: impl FnOnce() -> T) -> Arc<T> {
        let key = (TypeId::of::<T>(), key);
        let known = self.lock().get(&key).cloned();
        if let Some(known) = known.and_then(|known| known.downcast().ok()) {
            return known;
        }
        let made = Arc::new(make());
        self.lock().insert(key, Arc::clone(&made) as Arc<dyn Any + Send + Sync>);
        made
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<(TypeId, K), Arc<dyn Any + Send + Sync>>> {
        // Whoever panicked while it was locked had only read or added one entry.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
