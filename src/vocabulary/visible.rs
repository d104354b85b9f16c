//! The search for the nearest object, and for what stands before a light.

use super::entry::{When, entry, is, only};
use crate::algorithms::visible::{Event, Intersection};

vocabulary! {
    [] Event {
    };
    Event::Search { objects } => "Search" at "search" scope "scope-search"
        {
            "objects" = objects,
            "NearestT" = f64::INFINITY,
        }
        [
            entry("event-search", &[is("NearestT")]),
        ];
    Event::ObjectTested { object, t, nearest_t, nearer, .. } => "ObjectTested" at "test" or "nearer" if nearer,
        {
            "object" = object,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(When::True("nearer"), "event-object-tested-nearer", &[is("t < NearestT")]),
            only(When::Finite("t"), "event-object-tested-behind", &[is("t ≥ NearestT")]),
            entry("event-object-tested-missed", &[is("t")]),
        ];
    Event::LightTested { light, t, nearest_t, nearer } => "LightTested" at "test" or "nearer" if nearer,
        {
            "light" = light,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(When::True("nearer"), "event-light-tested-nearer", &[is("t < NearestT")]),
            only(When::Finite("t"), "event-light-tested-behind", &[is("t ≥ NearestT")]),
            entry("event-light-tested-missed", &[is("t")]),
        ];
    Event::Found { met } => "Found" at "found"
        {
            "met" = met_name(&met),
            "light" = met_light(&met),
            "object" = met_object(&met),
            "NearestT" = met.t(),
        }
        [
            only(When::Is("met", "object"), "event-found-object", &[is("NearestT")]),
            only(When::Is("met", "light"), "event-found-light", &[is("NearestT")]),
            entry("event-found-nothing", &[is("NearestT")]),
        ];
    Event::BetweenTested { object, t, distance, blocks, .. } => "BetweenTested" at "shadow"
        {
            "object" = object,
            "t" = t,
            "d" = distance,
            "blocks" = blocks,
        }
        [
            only(When::True("blocks"), "event-between-tested-blocks", &[is("t < d")]),
            only(When::Finite("t"), "event-between-tested-behind", &[is("t ≥ d")]),
            entry("event-between-tested-missed", &[is("t")]),
        ];
    Event::Unshadowing { object } => "Unshadowing" at "shadow"
        {
            "object" = object,
            "blocks" = false,
        }
        [
            entry("event-unshadowing", &[]),
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
