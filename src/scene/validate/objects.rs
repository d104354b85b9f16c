//! Objects: their names, materials and patches, and the limits of the scene. Shapes are for [`super::shapes`].

use super::rules::{CREASE, Check};
use super::{Limits, ReadFile};
use crate::scene::document::{Keyed, Place};
use crate::scene::file::ObjectFile;
use crate::scene::values::{Count, PatchCounts};
use crate::scene::{Material, MeshData, NormalsFrom, Object, Shape, VertexNormals};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::rc::Rc;

/// Indices of corners are 32 bits wide, and a mesh has at most three corners a triangle.
const MOST_TRIANGLES: u64 = 1 << 30;

/// The objects of one scene, and what they come to so far.
pub(super) struct Objects<'a, 'f> {
    pub check: &'a mut Check,
    pub read_file: &'a mut ReadFile<'f>,
    /// By path: several objects may show one mesh.
    pub meshes: HashMap<String, Rc<Result<MeshData, String>>>,
    materials: HashMap<&'a str, usize>,
    /// For messages.
    known_materials: String,
    limits: Limits,
    patches: u128,
    triangles: u128,
}

/// How a shape is divided into patches.
pub(super) enum Division {
    /// Into `[nu, nv]` cells; n means `[n, n]`.
    Quadrilateral,
    /// Into `[longitudes, latitudes]`.
    Sphere,
    /// So many triangles, each edge into n.
    Triangles(u64),
    /// Not at all, being a …
    Never(&'static str),
}

impl<'a, 'f> Objects<'a, 'f> {
    pub fn new(
        check: &'a mut Check,
        materials: &'a [Material],
        limits: &Limits,
        read_file: &'a mut ReadFile<'f>,
    ) -> Self {
        Objects {
            check,
            read_file,
            meshes: HashMap::new(),
            materials: materials
                .iter()
                .enumerate()
                .map(|(index, material)| (material.name.as_str(), index))
                .collect(),
            known_materials: known(materials),
            limits: Limits {
                max_triangles: limits.max_triangles.min(MOST_TRIANGLES),
                ..*limits
            },
            patches: 0,
            triangles: 0,
        }
    }

    pub fn all(mut self, root: &Place, files: Vec<Keyed<ObjectFile>>) -> Vec<Object> {
        let mut indices: HashMap<String, usize> = HashMap::with_capacity(files.len());
        let objects = root.key("objects");
        files
            .into_iter()
            .enumerate()
            .filter_map(|(index, Keyed(file))| {
                let place = objects.index(index);
                match indices.entry(file.name.clone()) {
                    Entry::Occupied(taken) => {
                        let message = format!(
                            "found {:?}, which is the name of {objects}[{}] too; every object has a name of its own",
                            file.name,
                            taken.get()
                        );
                        self.check.refuse(&place.key("name"), message);
                    }
                    Entry::Vacant(free) => {
                        free.insert(index);
                    }
                }
                self.object(&place, file)
            })
            .collect()
    }

    fn object(&mut self, place: &Place, file: ObjectFile) -> Option<Object> {
        let material = self.materials.get(&*file.material).copied();
        if material.is_none() {
            let message = format!(
                "found {:?}, which is no material of this scene; {}",
                file.material, self.known_materials
            );
            self.check.refuse(&place.key("material"), message);
        }
        if file.transform.is_some() && file.mesh.is_none() {
            self.check.refuse(
                &place.key("transform"),
                "found a transform on a shape that takes none; only meshes do".into(),
            );
        }
        let vertex_normals = self.vertex_normals(place, &file);
        let (shape, division) = self.shape(place, &file, vertex_normals)?;
        let patches = self.patches(&place.key("patches"), &division, file.patches);
        let divisions = self.divisions(&place.key("divisions"), &division, file.divisions);
        Some(Object {
            name: file.name,
            material: material?,
            shape,
            patches,
            divisions,
            casts_shadow: file.casts_shadow.unwrap_or(true),
            vertex_normals,
        })
    }

    /// What the keys `normals` and `crease_degrees` say; notes where one has no effect.
    fn vertex_normals(&mut self, object: &Place, file: &ObjectFile) -> VertexNormals {
        let place = object.key("normals");
        let crease_place = object.key("crease_degrees");
        let degrees = file.crease_degrees.map_or(180.0, |degrees| {
            self.check.number(&crease_place, degrees, CREASE)
        });
        let averaged = NormalsFrom::Averaged.name();
        let written = file.normals.as_deref().unwrap_or(averaged);
        let normals = match NormalsFrom::from_name(written) {
            Some(NormalsFrom::Averaged) => VertexNormals::Averaged {
                crease: degrees.to_radians(),
            },
            Some(NormalsFrom::File) if file.mesh.is_none() => {
                let why = "only meshes have normals in a file; those of the faces are averaged";
                self.check
                    .note(&place, "\"file\" on a shape without a file", why);
                VertexNormals::AVERAGED
            }
            Some(NormalsFrom::File) => VertexNormals::File,
            Some(NormalsFrom::Face) => VertexNormals::Face,
            None => {
                let known = NormalsFrom::ALL.map(NormalsFrom::name).join(", ");
                let message = format!("found {written:?}; allowed are {known}");
                self.check.refuse(&place, message);
                VertexNormals::AVERAGED
            }
        };
        if file.crease_degrees.is_some() && written != averaged {
            let what = format!("a crease angle with normals {written:?}");
            self.check.note(
                &crease_place,
                what,
                "only normals that are averaged have one",
            );
        }
        if file.plane.is_some() && (file.normals.is_some() || file.crease_degrees.is_some()) {
            let why = "the scan-line methods, which interpolate normals, leave planes out";
            self.check.note(object, "vertex normals of a plane", why);
        }
        normals
    }

    fn shape(
        &mut self,
        object: &Place,
        file: &ObjectFile,
        vertex_normals: VertexNormals,
    ) -> Option<(Shape, Division)> {
        let found: Vec<&str> = [
            ("sphere", file.sphere.is_some()),
            ("plane", file.plane.is_some()),
            ("polygon", file.polygon.is_some()),
            ("cylinder", file.cylinder.is_some()),
            ("bezier", file.bezier.is_some()),
            ("mesh", file.mesh.is_some()),
        ]
        .into_iter()
        .filter_map(|(key, is_there)| is_there.then_some(key))
        .collect();
        let [key] = found[..] else {
            let found = match found.len() {
                0 => "no shape".to_owned(),
                n => format!("{n} shapes (`{}`)", found.join("`, `")),
            };
            self.check.refuse(
                object,
                format!(
                    "found {found}; an object has exactly one of `sphere`, `plane`, `polygon`, `cylinder`, `bezier`, `mesh`"
                ),
            );
            return None;
        };
        let place = &object.key(key);
        file.sphere
            .as_ref()
            .map(|Keyed(sphere)| self.sphere(place, sphere))
            .or_else(|| Some(self.plane(place, &file.plane.as_ref()?.0)))
            .or_else(|| self.polygon(place, &file.polygon.as_ref()?.0))
            .or_else(|| Some(self.cylinder(place, &file.cylinder.as_ref()?.0)))
            .or_else(|| self.bezier(place, &file.bezier.as_ref()?.0))
            .or_else(|| {
                let mesh = &file.mesh.as_ref()?.0;
                self.mesh(object, mesh, file.transform.as_ref(), vertex_normals)
            })
    }

    /// Patches along u and v; 1 where the file has none, or a wrong number.
    fn patches(
        &mut self,
        place: &Place,
        division: &Division,
        written: Option<PatchCounts>,
    ) -> [u32; 2] {
        let Some(written) = written else {
            return match division {
                Division::Sphere => Object::SPHERE_PATCHES,
                _ => [1, 1],
            };
        };
        let (grid, shown) = match written {
            PatchCounts::Each(n) => ([n, n], n.to_string()),
            PatchCounts::Grid(grid) => (grid, format!("{grid:?}")),
        };
        let is_one_number = matches!(written, PatchCounts::Each(_));
        let (is_allowed, allowed) = match division {
            Division::Quadrilateral => (
                grid[0] >= 1 && grid[1] >= 1,
                "a number of 1 or more, or [nu, nv] with both 1 or more",
            ),
            Division::Sphere => (
                !is_one_number && grid[0] >= 3 && grid[1] >= 2,
                "[longitudes, latitudes], at least [3, 2]",
            ),
            Division::Triangles(_) => (
                is_one_number && grid[0] >= 1,
                "a number of 1 or more: into so many each edge of its triangles is divided",
            ),
            Division::Never(_) => (grid == [1, 1], "1"),
        };
        if !is_allowed {
            let on = match division {
                Division::Quadrilateral => "a quadrilateral",
                Division::Sphere => "a sphere",
                Division::Triangles(_) => "a triangle, mesh, cylinder or Bézier surface",
                Division::Never(shape) => shape,
            };
            let message = format!("found {shown} on {on}; allowed is {allowed}");
            self.check.refuse(place, message);
            return [1, 1];
        }
        let triangles = match division {
            Division::Triangles(count) => u128::from(*count),
            _ => 1,
        };
        let count = triangles.saturating_mul(u128::from(grid[0]) * u128::from(grid[1]));
        let most = u128::from(self.limits.max_patches);
        let in_all = self.patches.saturating_add(count);
        match grid.map(u32::try_from) {
            [Ok(nu), Ok(nv)] if in_all <= most => {
                self.patches = in_all;
                [nu, nv]
            }
            _ => {
                let message = format!(
                    "found {shown}, which makes {count} patches here and {in_all} so far; at most {most} are allowed in a scene (--max-patches)"
                );
                self.check.refuse(place, message);
                [1, 1]
            }
        }
    }

    /// Of a sphere.
    fn divisions(&mut self, place: &Place, division: &Division, written: Option<Count>) -> u32 {
        let Some(Count(written)) = written else {
            return Object::DIVISIONS;
        };
        let most = Object::MOST_DIVISIONS;
        let found = u32::try_from(written).ok();
        let divisions = found.filter(|divisions| (2..=most).contains(divisions));
        let message = match (division, divisions) {
            (Division::Sphere, Some(divisions)) => {
                let triangles = 4 * u128::from(divisions).pow(2);
                let has_room = self.has_room_for(place, triangles);
                return if has_room {
                    divisions
                } else {
                    Object::DIVISIONS
                };
            }
            (Division::Sphere, None) => {
                format!("found {written}; allowed are whole numbers from 2 to {most}")
            }
            _ => "found divisions on a shape that takes none here; only spheres do".into(),
        };
        self.check.refuse(place, message);
        Object::DIVISIONS
    }

    /// Whether so many triangles more are within the limit; said before anything is made of them.
    pub fn has_room_for(&mut self, place: &Place, triangles: u128) -> bool {
        let most = self.limits.max_triangles;
        let in_all = self.triangles.saturating_add(triangles);
        let has_room = in_all <= u128::from(most);
        if has_room {
            self.triangles = in_all;
        } else {
            let message = format!(
                "found {triangles} triangles here and {in_all} so far; at most {most} are allowed in a scene (--max-triangles)"
            );
            self.check.refuse(place, message);
        }
        has_room
    }

    pub fn max_triangles(&self) -> u64 {
        self.limits.max_triangles
    }
}

/// The names that an object may give as its material.
fn known(materials: &[Material]) -> String {
    const SHOWN: usize = 8;
    if materials.is_empty() {
        return "the scene has none".into();
    }
    let names: Vec<String> = materials
        .iter()
        .take(SHOWN)
        .map(|material| format!("{:?}", material.name))
        .collect();
    let more = match materials.len().saturating_sub(SHOWN) {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    format!("it has {}{more}", names.join(", "))
}
