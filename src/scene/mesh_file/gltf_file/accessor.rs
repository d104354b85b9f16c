//! Accessors: lists of vectors in the bytes of a buffer (glTF 2.0, §3.6).

use gltf::Accessor;
use gltf::accessor::DataType;
use gltf::accessor::sparse::{IndexType, Sparse};
use gltf::buffer::View;
use std::borrow::Cow;

/// Reads accessors, a bounded number of vectors in all.
pub(super) struct Accessors<'a> {
    buffers: &'a [Cow<'static, [u8]>],
    /// How many vectors may still be read: lists may lie on each other, so the bytes of the file are no bound.
    left: u64,
}

impl<'a> Accessors<'a> {
    pub fn new(buffers: &'a [Cow<'static, [u8]>], max_triangles: u64) -> Self {
        Accessors {
            buffers,
            left: max_triangles.saturating_mul(16).saturating_add(1 << 20),
        }
    }

    /// Errors: numbers that are no vectors of `N`, a list that leaves its buffer, or too many in all; as a sentence.
    pub fn vectors<const N: usize>(
        &mut self,
        accessor: &Accessor,
    ) -> Result<Vec<[f64; N]>, String> {
        let place = || format!("accessors[{}]", accessor.index());
        let found = accessor.dimensions().multiplicity();
        if found != N {
            return Err(format!("{} has {found} numbers each, not {N}", place()));
        }
        let count = accessor.count() as u64;
        self.left = self.left.checked_sub(count).ok_or_else(|| {
            format!(
                "{} has {count} entries, more than --max-triangles allows",
                place()
            )
        })?;
        let size = accessor.size();
        let number = |bytes: &[u8]| number(bytes, accessor.data_type(), accessor.normalized());
        let vector = |bytes: &[u8]| {
            let mut numbers = bytes.chunks_exact(size / N).map(number);
            std::array::from_fn(|_| numbers.next().unwrap_or_default())
        };
        let mut vectors = match accessor.view() {
            None => vec![[0.0; N]; accessor.count()],
            Some(view) => {
                let stride = view.stride().unwrap_or(size);
                let list = self.list(&view, accessor.offset(), accessor.count(), size, stride);
                list.ok_or_else(|| outside(&place()))?.map(vector).collect()
            }
        };
        if let Some(sparse) = accessor.sparse() {
            self.replace(&sparse, size, &mut vectors, vector)
                .ok_or_else(|| outside(&place()))?;
        }
        Ok(vectors)
    }

    /// The bytes of each entry. None where the list leaves its view, or the view its buffer.
    fn list(
        &self,
        view: &View,
        offset: usize,
        count: usize,
        size: usize,
        stride: usize,
    ) -> Option<impl Iterator<Item = &'a [u8]> + use<'a>> {
        let end = view.offset().checked_add(view.length())?;
        let buffer: &'a [u8] = self.buffers.get(view.buffer().index())?;
        let bytes = buffer.get(view.offset()..end)?;
        let needed = match count {
            0 => 0,
            _ => (count - 1).checked_mul(stride)?.checked_add(size)?,
        };
        let bytes = bytes.get(offset..offset.checked_add(needed)?)?;
        (stride >= size).then(|| (0..count).map(move |i| &bytes[i * stride..i * stride + size]))
    }

    /// Puts the entries of a sparse accessor in their places.
    fn replace<const N: usize>(
        &self,
        sparse: &Sparse,
        size: usize,
        vectors: &mut [[f64; N]],
        vector: impl Fn(&[u8]) -> [f64; N],
    ) -> Option<()> {
        let (indices, values, count) = (sparse.indices(), sparse.values(), sparse.count());
        let (kind, width) = match indices.index_type() {
            IndexType::U8 => (DataType::U8, 1),
            IndexType::U16 => (DataType::U16, 2),
            IndexType::U32 => (DataType::U32, 4),
        };
        let places = self.list(&indices.view(), indices.offset(), count, width, width)?;
        let values = self.list(&values.view(), values.offset(), count, size, size)?;
        for (place, value) in places.zip(values) {
            *vectors.get_mut(number(place, kind, false) as usize)? = vector(value);
        }
        Some(())
    }
}

fn outside(place: &str) -> String {
    format!("{place} leaves its buffer")
}

/// A number of such a type; where normalized, as a share of the largest (§3.6.2.2).
fn number(bytes: &[u8], kind: DataType, normalized: bool) -> f64 {
    let mut padded = [0; 4];
    padded[..bytes.len().min(4)].copy_from_slice(&bytes[..bytes.len().min(4)]);
    let [first, second, ..] = padded;
    let (value, largest) = match kind {
        DataType::F32 => return f32::from_le_bytes(padded).into(),
        DataType::I8 => (f64::from(first as i8), 127.0),
        DataType::U8 => (f64::from(first), 255.0),
        DataType::I16 => (f64::from(i16::from_le_bytes([first, second])), 32767.0),
        DataType::U16 => (f64::from(u16::from_le_bytes([first, second])), 65535.0),
        DataType::U32 => (f64::from(u32::from_le_bytes(padded)), 4_294_967_295.0),
    };
    if normalized {
        (value / largest).max(-1.0)
    } else {
        value
    }
}
