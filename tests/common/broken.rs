//! A scene to be broken, and many ways to break it.

/// A whole scene of many parts, to be broken in one place.
pub const GOOD: &str = r#"{ "schema": 1,
  "background": [0.2, 0.3, 0.5],
  "ambient": [1, 1, 1],
  "path_attenuation": [1, 0, 0],
  "camera": { "eye": [0, 1.5, -6], "target": [0, 0.5, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": {
    "red": { "diffuse": [0.5, 0.1, 0.1], "specular": 0.5, "shininess": 40, "highlight": "phong", "ior": 1.5,
             "reflectance": [0.8, 0.2, 0.2], "texture": { "checker": { "colors": [[1, 1, 1], [0, 0, 0]], "scale": 1.0 } } },
    "blue": {} },
  "objects": [
    { "name": "ball", "material": "red", "sphere": { "center": [0, 0.8, 0], "radius": 0.8 } },
    { "name": "floor", "material": "red", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
    { "name": "wall", "material": "red", "polygon": { "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }, "patches": [8, 8] },
    { "name": "pot", "material": "red", "mesh": { "file": "meshes/pot.obj" }, "casts_shadow": true,
      "transform": { "translate": [0, 0, 0], "rotate_degrees": [0, 30, 0], "scale": 1.0 } },
    { "name": "can", "material": "blue", "cylinder": { "base": [0,0,0], "axis": [0,1,0], "radius": 1, "height": 2, "capped": true } },
    { "name": "sheet", "material": "blue", "bezier": { "divisions": 4, "patches": [[
      [0,0,0],[1,0,0],[2,0,0],[3,0,0],[0,1,0],[1,1,1],[2,1,1],[3,1,0],[0,2,0],[1,2,1],[2,2,1],[3,2,0],[0,3,0],[1,3,0],[2,3,0],[3,3,0]]] } } ],
  "lights": [
    { "point": { "position": [4, 6, -5], "color": [1, 1, 1], "attenuation": [1, 0, 0], "radius": 0 } },
    { "directional": { "toward": [0, -1, 0] } } ] }"#;

/// The mesh that it names.
pub const POT: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n";

/// What is replaced in the good scene, by what, and what the message says: place and reason.
#[rustfmt::skip]
pub const BROKEN: &[(&str, &str, &[&str])] = &[
    // Schema and the outermost keys.
    ("\"schema\": 1,", "", &["the key `schema` is missing"]),
    ("\"schema\": 1", "\"schema\": 2", &["schema: invalid value: integer `2`, expected 1"]),
    ("\"schema\": 1", "\"schema\": \"1\"", &["line 1", "schema: invalid type: string"]),
    ("\"schema\": 1", "\"schema\": null", &["schema: invalid type: null"]),
    ("\"schema\": 1,", "\"schema\": 1, \"schema\": 1,", &["duplicate field `schema`"]),
    ("\"background\"", "\"backgruond\"", &["line 2", "unknown field `backgruond`, expected one of", "`background`"]),
    ("\"objects\"", "\"lights\"", &["lights[0].name: unknown field `name`"]),
    // Types.
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3]", &["line 2", "background", "invalid length 2, expected a list of three numbers"]),
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3, 0.5, 1]", &["background", "invalid length 4"]),
    ("[0.2, 0.3, 0.5]", "0.5", &["background: invalid type: floating point `0.5`, expected a list of three numbers"]),
    ("[0.2, 0.3, 0.5]", "null", &["background: invalid type: null"]),
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3, \"0.5\"]", &["background[2]: invalid type: string \"0.5\", expected a number"]),
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3, NaN]", &["line 2", "background[2]", "expected a value"]),
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3, 1e400]", &["line 2", "background[2]", "not finite"]),
    ("[0.2, 0.3, 0.5]", "[0.2, 0.3, -1e999]", &["background[2]", "not finite"]),
    ("\"specular\": 0.5", "\"specular\": \"half\"", &["materials.red.specular", "expected a number or a list of three numbers"]),
    ("\"specular\": 0.5", "\"specular\": [1, 2]", &["materials.red.specular", "invalid length 2"]),
    ("\"specular\": 0.5", "\"specular\": [1, 2, true]", &["materials.red.specular[2]", "boolean `true`"]),
    ("\"casts_shadow\": true", "\"casts_shadow\": 1", &["objects[3].casts_shadow", "expected a boolean"]),
    ("{ \"eye\": [0, 1.5, -6], \"target\": [0, 0.5, 0], \"up\": [0, 1, 0], \"fov_x_degrees\": 40 }", "[[0, 1.5, -6], [0, 0.5, 0], [0, 1, 0], 40]", &["camera: invalid type: sequence, expected an object"]),
    ("{ \"center\": [0, 0.8, 0], \"radius\": 0.8 }", "[[0, 0.8, 0], 0.8]", &["objects[0].sphere", "expected an object"]),
    ("\"divisions\": 4", "\"divisions\": 4.5", &["objects[5].bezier.divisions", "expected a whole number"]),
    ("\"divisions\": 4", "\"divisions\": -4", &["objects[5].bezier.divisions", "integer `-4`"]),
    ("\"patches\": [8, 8]", "\"patches\": [8]", &["objects[2].patches", "expected a whole number, or a list of two whole numbers"]),
    ("\"patches\": [8, 8]", "\"patches\": 1e3", &["objects[2].patches", "floating point"]),
    // Keys.
    (", \"fov_x_degrees\": 40", "", &["line 5", "camera: missing field `fov_x_degrees`"]),
    ("\"fov_x_degrees\"", "\"fov\"", &["camera.fov: unknown field `fov`, expected one of `eye`"]),
    ("\"blue\": {}", "\"blue\": { \"metallic\": 1 }", &["materials.blue.metallic: unknown field"]),
    ("\"blue\": {}", "\"red\": {}", &["the name \"red\" is given twice"]),
    ("\"radius\": 0.8", "\"radius\": 0.8, \"radius\": 0.9", &["objects[0].sphere", "duplicate field `radius`"]),
    ("\"radius\": 0.8", "\"diameter\": 0.8", &["unknown field `diameter`, expected `center` or `radius`"]),
    ("{ \"directional\":", "{ \"spot\":", &["lights[1].spot: unknown field `spot`, expected `point` or `directional`"]),
    ("\"checker\":", "\"marble\":", &["texture.marble: unknown field `marble`, expected `checker`"]),
    // The camera.
    ("\"target\": [0, 0.5, 0]", "\"target\": [0, 1.5, -6]", &["camera.target: found [0.0, 1.5, -6.0], the same place as `eye`"]),
    ("\"up\": [0, 1, 0]", "\"up\": [0, -2, 12]", &["camera.up: found [0.0, -2.0, 12.0], parallel to the view"]),
    ("\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]", &["camera.up: found [0, 0, 0]"]),
    ("\"fov_x_degrees\": 40", "\"fov_x_degrees\": 180", &["camera.fov_x_degrees: found 180.0; allowed are angles greater than 0 and less than 180"]),
    ("\"fov_x_degrees\": 40", "\"fov_x_degrees\": 0", &["camera.fov_x_degrees: found 0.0"]),
    ("\"eye\": [0, 1.5, -6]", "\"eye\": [0, 1e300, -6]", &["camera.eye[1]: found 1e300; allowed are numbers from -1e75 to 1e75"]),
    // Materials.
    ("\"diffuse\": [0.5, 0.1, 0.1]", "\"diffuse\": [0.5, -0.1, 0.1]", &["materials.red.diffuse[1]: found -0.1; allowed are numbers of 0 or more"]),
    ("\"specular\": 0.5", "\"reflection\": -0.5", &["materials.red.reflection: found -0.5"]),
    ("\"specular\": 0.5", "\"transmission\": [0, 0, -0.5]", &["materials.red.transmission[2]: found -0.5"]),
    ("\"shininess\": 40", "\"shininess\": -1", &["materials.red.shininess: found -1.0"]),
    ("\"highlight\": \"phong\"", "\"highlight\": \"gouraud\"", &["materials.red.highlight: found \"gouraud\"; allowed are \"blinn\" and \"phong\""]),
    ("\"ior\": 1.5", "\"ior\": 0", &["materials.red.ior: found 0.0; allowed are numbers greater than 0"]),
    ("\"reflectance\": [0.8, 0.2, 0.2]", "\"reflectance\": [0.8, 0.2, 1.2]", &["materials.red.reflectance[2]: found 1.2; allowed are numbers from 0 to 1"]),
    ("[[1, 1, 1], [0, 0, 0]]", "[[1, 1, 1]]", &["materials.red.texture.checker.colors: found 1 colours; allowed are exactly 2"]),
    ("\"scale\": 1.0 } } }", "\"scale\": 0 } } }", &["materials.red.texture.checker.scale: found 0.0"]),
    // Objects.
    ("\"name\": \"floor\"", "\"name\": \"ball\"", &["objects[1].name: found \"ball\", which is the name of objects[0] too"]),
    ("\"material\": \"blue\", \"cyl", "\"material\": \"bleu\", \"cyl", &["objects[4].material: found \"bleu\"", "it has \"red\", \"blue\""]),
    ("\"sphere\": {", "\"plane\": { \"point\": [0,0,0], \"normal\": [0,1,0] }, \"sphere\": {", &["objects[0]: found 2 shapes (`sphere`, `plane`)"]),
    (", \"sphere\": { \"center\": [0, 0.8, 0], \"radius\": 0.8 }", "", &["objects[0]: found no shape; an object has exactly one of `sphere`"]),
    ("\"radius\": 0.8", "\"radius\": -0.8", &["objects[0].sphere.radius: found -0.8; allowed are lengths greater than 0"]),
    ("\"radius\": 0.8", "\"radius\": 0", &["objects[0].sphere.radius: found 0.0"]),
    ("\"normal\": [0, 1, 0]", "\"normal\": [0, 0, 0]", &["objects[1].plane.normal: found [0, 0, 0], which has no direction"]),
    ("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]", "[[0,0,0],[1,0,0]]", &["objects[2].polygon.vertices: found 2 vertices"]),
    ("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]", "[[0.1,0.1,0.1],[0.2,0.2,0.2],[0.3,0.3,0.3],[0.7,0.7,0.7]]", &["objects[2].polygon.vertices: found vertices on one line"]),
    ("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]", "[[5,5,5],[5,5,5],[5,5,5]]", &["objects[2].polygon.vertices", "a polygon has an area"]),
    ("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]", "[[0,0,0],[1,0,0],[1,1,0.5],[0.5,1.5,0],[0,1,0]]", &["objects[2].polygon.vertices", "mean plane"]),
    ("\"axis\": [0,1,0]", "\"axis\": [0,0,0]", &["objects[4].cylinder.axis: found [0, 0, 0]"]),
    ("\"height\": 2", "\"height\": 0", &["objects[4].cylinder.height: found 0.0"]),
    ("\"divisions\": 4", "\"divisions\": 0", &["objects[5].bezier.divisions: found 0"]),
    ("\"divisions\": 4", "\"divisions\": 4000000000", &["objects[5].bezier.divisions", "at most 5000000 are allowed in a scene (--max-triangles)"]),
    ("\"divisions\": 4", "\"divisions\": 18446744073709551615", &["objects[5].bezier.divisions", "--max-triangles"]),
    (",[3,3,0]]] }", "]] }", &["objects[5].bezier.patches[0]: found 15 points; a bicubic patch has 16"]),
    // Patches.
    ("\"patches\": [8, 8]", "\"patches\": [0, 8]", &["objects[2].patches: found [0, 8]"]),
    ("\"patches\": [8, 8]", "\"patches\": [1000, 1000]", &["objects[2].patches: found [1000, 1000], which makes 1000000 patches here", "at most 100000", "--max-patches"]),
    ("\"patches\": [8, 8]", "\"patches\": 18446744073709551615", &["objects[2].patches", "--max-patches"]),
    ("\"casts_shadow\": true", "\"patches\": 1000", &["objects[3].patches: found 1000, which makes 2000000 patches"]),
    ("\"casts_shadow\": true", "\"patches\": [2, 2]", &["objects[3].patches: found [2, 2] on a triangle, mesh"]),
    ("\"sphere\":", "\"patches\": 16, \"sphere\":", &["objects[0].patches: found 16 on a sphere; allowed is [longitudes, latitudes]"]),
    ("\"sphere\":", "\"patches\": [2, 8], \"sphere\":", &["objects[0].patches: found [2, 8]", "at least [3, 2]"]),
    ("\"plane\":", "\"patches\": 4, \"plane\":", &["objects[1].patches: found 4 on a plane"]),
    // Meshes.
    ("meshes/pot.obj", "meshes/cup.obj", &["objects[3].mesh.file: cannot read \"meshes/cup.obj\": no such file"]),
    ("meshes/pot.obj", "../pot.obj", &["objects[3].mesh.file: found \"../pot.obj\", which leaves the folder"]),
    ("meshes/pot.obj", "/etc/passwd", &["objects[3].mesh.file", "an absolute path"]),
    ("meshes/pot.obj", "", &["objects[3].mesh.file", "empty"]),
    ("meshes/pot.obj", "meshes/pot.glb", &["objects[3].mesh.file", "glTF is not supported"]),
    ("\"scale\": 1.0 } },", "\"scale\": 0 } },", &["objects[3].transform.scale: found 0.0"]),
    ("\"scale\": 1.0 } },", "\"scale\": -1 } },", &["objects[3].transform.scale: found -1.0"]),
    ("\"sphere\":", "\"transform\": {}, \"sphere\":", &["objects[0].transform", "only meshes do"]),
    // Lights.
    ("\"attenuation\": [1, 0, 0], ", "\"attenuation\": [0, 0, 0], ", &["lights[0].point.attenuation: found [0, 0, 0]"]),
    ("\"attenuation\": [1, 0, 0], ", "\"attenuation\": [1, -1, 0], ", &["lights[0].point.attenuation[1]: found -1.0"]),
    ("\"path_attenuation\": [1, 0, 0]", "\"path_attenuation\": [0, 0, 0]", &["path_attenuation: found [0, 0, 0]"]),
    ("\"radius\": 0 }", "\"radius\": -1 }", &["lights[0].point.radius: found -1.0; allowed are 0 or a radius"]),
    ("\"toward\": [0, -1, 0]", "\"toward\": [0, 0, 0]", &["lights[1].directional.toward: found [0, 0, 0]"]),
    ("\"directional\": {", "\"point\": { \"position\": [0,0,0] }, \"directional\": {", &["lights[1]: found two kinds of light"]),
];
