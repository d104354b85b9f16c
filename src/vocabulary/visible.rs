//! The search for the nearest object, and for what stands before a light.

use super::entry::{When, entry, is, only};
use crate::algorithms::visible::{Event, Intersection};

vocabulary! {
    [] Event {
    };
    Event::Search { objects } => "Search" at "search" scope ("search", "pencarian")
        {
            "objects" = objects,
            "NearestT" = f64::INFINITY,
        }
        [
            entry(
                "The search begins: nothing is found yet, and {objects} objects are to be tested.",
                "Pencarian dimulai: belum ada yang ditemukan, {objects} objek akan diuji.",
                &[is("{NearestT}")],
            ),
        ];
    Event::ObjectTested { object, t, nearest_t, nearer, .. } => "ObjectTested" at "test" or "nearer" if nearer,
        {
            "object" = object,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(
                When::True("nearer"),
                "The ray meets object {object} nearer than all before: it is NearestObject now, and t is NearestT.",
                "Sinar mengenai objek {object} lebih dekat dari semua sebelumnya: kini NearestObject, dan t menjadi NearestT.",
                &[is("{t} < {NearestT}")],
            ),
            only(
                When::Finite("t"),
                "The ray meets object {object}, but not nearer than what was found before.",
                "Sinar mengenai objek {object}, tetapi tidak lebih dekat dari yang sudah ditemukan.",
                &[is("{t} ≥ {NearestT}")],
            ),
            entry(
                "The ray misses object {object}: NearestT stays.",
                "Sinar meleset dari objek {object}: NearestT tetap.",
                &[is("{t}")],
            ),
        ];
    Event::LightTested { light, t, nearest_t, nearer } => "LightTested" at "test" or "nearer" if nearer,
        {
            "light" = light,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(
                When::True("nearer"),
                "The ray meets the ball of light {light} nearer than all objects.",
                "Sinar mengenai bola cahaya {light} lebih dekat dari semua objek.",
                &[is("{t} < {NearestT}")],
            ),
            only(
                When::Finite("t"),
                "The ball of light {light} lies behind what was found before.",
                "Bola cahaya {light} berada di balik yang sudah ditemukan.",
                &[is("{t} ≥ {NearestT}")],
            ),
            entry(
                "The ray misses the ball of light {light}.",
                "Sinar meleset dari bola cahaya {light}.",
                &[is("{t}")],
            ),
        ];
    Event::Found { met } => "Found" at "found"
        {
            "met" = met_name(&met),
            "light" = met_light(&met),
            "object" = met_object(&met),
            "NearestT" = met.t(),
        }
        [
            only(
                When::Is("met", "object"),
                "The search is over: object {object} is the nearest.",
                "Pencarian selesai: objek {object} yang terdekat.",
                &[is("{NearestT}")],
            ),
            only(
                When::Is("met", "light"),
                "The search is over: light {light} itself is the nearest.",
                "Pencarian selesai: cahaya {light} sendiri yang terdekat.",
                &[is("{NearestT}")],
            ),
            entry(
                "The search is over: the ray meets nothing.",
                "Pencarian selesai: sinar tidak mengenai apa pun.",
                &[is("{NearestT}")],
            ),
        ];
    Event::BetweenTested { object, t, distance, blocks, .. } => "BetweenTested" at "shadow"
        {
            "object" = object,
            "t" = t,
            "d" = distance,
            "blocks" = blocks,
        }
        [
            only(
                When::True("blocks"),
                "Object {object} lies between the surface and the light.",
                "Objek {object} berada di antara permukaan dan cahaya.",
                &[is("{t} < {d}")],
            ),
            only(
                When::Finite("t"),
                "Object {object} lies behind the light: it does not block it.",
                "Objek {object} berada di balik cahaya: tidak menghalangi.",
                &[is("{t} ≥ {d}")],
            ),
            entry(
                "The shadow ray misses object {object}.",
                "Sinar bayangan meleset dari objek {object}.",
                &[is("{t}")],
            ),
        ];
    Event::Unshadowing { object } => "Unshadowing" at "shadow"
        {
            "object" = object,
            "blocks" = false,
        }
        [
            entry(
                "Object {object} casts no shadow: it is passed over.",
                "Objek {object} tidak membuat bayangan: dilewati.",
                &[],
            ),
        ];
}

fn met_name(met: &Intersection) -> &'static str {
    match met {
        Intersection::Nothing => "nothing",
        Intersection::Light { .. } => "light",
        Intersection::Object(_) => "object",
    }
}

fn met_light(met: &Intersection) -> Option<u32> {
    match *met {
        Intersection::Light { light, .. } => Some(light),
        _ => None,
    }
}

fn met_object(met: &Intersection) -> Option<u32> {
    match met {
        Intersection::Object(hit) => Some(hit.object),
        _ => None,
    }
}
