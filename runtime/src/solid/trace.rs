//! A solid in a scene.

use core::any::Any;
use std::ops::Range;

use super::cells::Cells;
use super::leaf::PreparedLeaf;
use super::over::{OnPictures, SurveySolid};
use super::sweep::Face;
use super::tile::{Explorer, Known, Look};
use super::tree::Node;
use super::{Part, Side, Solid};
use crate::beam::{Findings, Frame, Hint, Request, Rows};
use crate::camera::Ray;
use crate::interval::{Interval, Isa, Kernel, Packet};
use crate::ray::Lines;
use crate::render::tile::{CELLS, Event, PACKETS_OF_CELL, PacketRays, Tile, View};
use crate::scene::{Label, Prepared, Search, TileJob, Trace};
use crate::solve::Settings;
use crate::space::{Boxes, Division, eight};
use crate::span::Span8;
use crate::surface::{Active, ParameterError, Regions};
use crate::trace::{BeamOf, Leaves, Trail, WithBeams, segment};
use crate::verdict::Verdict;

impl Trace for Solid {
    fn name(&self) -> &'static str {
        "solid"
    }

    fn labels(&self) -> Vec<Label> {
        let label = |part: &Part| Label {
            name: part.leaf.name(),
            colour: part.colour,
        };
        self.parts.iter().map(label).collect()
    }

    fn check(&self) -> Result<(), ParameterError> {
        self.parts.iter().try_for_each(|part| part.leaf.check())
    }

    fn domain(&self) -> Option<[[f64; 3]; 2]> {
        self.domain_of(&self.node)
    }

    fn prepare(&self) -> Box<dyn Prepared + '_> {
        Box::new(self.ready())
    }
}

impl Solid {
    /// Runs the surface stages.
    pub(super) fn ready(&self) -> PreparedSolid<'_> {
        let mut node = self.node.clone();
        node.sort(&|index| self.parts[index].leaf.cost());
        PreparedSolid {
            node,
            leaves: self.parts.iter().map(|part| part.leaf.prepare()).collect(),
        }
    }

    /// The box outside of which a node has no points, as far as its operands' boxes say.
    fn domain_of(&self, node: &Node) -> Option<[[f64; 3]; 2]> {
        match node {
            Node::Leaf(index) => self.parts[*index].leaf.domain(),
            Node::Not(_) => None,
            Node::Both(parts) => {
                let boxes = parts.iter().filter_map(|part| self.domain_of(part));
                boxes.reduce(|a, b| {
                    let low = [0, 1, 2].map(|k| a[0][k].max(b[0][k]));
                    // Operands apart leave no box; one without volume does.
                    [low, [0, 1, 2].map(|k| a[1][k].min(b[1][k]).max(low[k]))]
                })
            }
            Node::Either(parts) => {
                let boxes: Option<Vec<_>> = parts.iter().map(|part| self.domain_of(part)).collect();
                crate::scene::hull(&boxes?)
            }
        }
    }
}

/// A solid after its operands' surface stages.
pub(super) struct PreparedSolid<'a> {
    pub node: Node,
    pub leaves: Vec<Box<dyn PreparedLeaf + 'a>>,
}

impl PreparedSolid<'_> {
    /// The faces along each of some rays, in ascending order; `found` is told of each ray, and is to say where the ray is
    /// to be searched from then on. False if no ray has any.
    pub(super) fn faces(
        &self,
        look: &Look,
        known: Known,
        (tile, first): (&mut Tile, usize),
        over: &[Span8],
        mut found: impl FnMut(&mut Tile, usize, usize, &[Face]),
    ) -> bool {
        let packets = &tile.packets[first..first + over.len()];
        let explored = Explorer::new(self, look, packets, &mut tile.counts).explore(known, over);
        let Some(explored) = explored else {
            return false;
        };
        let mut sweep = explored.sweep(look.first_only);
        for (packet, span) in over.iter().enumerate() {
            for lane in 0..8 {
                let ray = span.of(lane);
                if ray.lo <= ray.hi {
                    explored.faces(&mut sweep, packet, lane, ray);
                    found(tile, first + packet, lane, &sweep.faces);
                }
            }
        }
        true
    }

    /// The faces along each ray of some packets, of which nothing is known.
    fn faces_of(
        &self,
        look: &Look,
        domain: &[[f64; 3]; 2],
        tile: &mut Tile,
        packets: Range<usize>,
        found: impl FnMut(&mut Tile, usize, usize, &[Face]),
    ) {
        let of_cell = &tile.packets[packets.clone()];
        let over = look.isa.run(Segments {
            own: (*domain != tile.domain).then_some(domain),
            packets: of_cell,
        });
        if over.iter().all(Span8::is_empty) {
            tile.counts.apart += tile.pixels(packets.start / PACKETS_OF_CELL);
            return;
        }
        if let Some(beam) = look.isa.run(BeamOf { packets: of_cell }) {
            self.faces(
                look,
                Known::Around(&beam),
                (tile, packets.start),
                &over,
                found,
            );
        }
    }
}

/// The part of each ray that is of interest.
pub(super) struct Segments<'a> {
    /// The solid's box, if it is not the scene's.
    pub own: Option<&'a [[f64; 3]; 2]>,
    pub packets: &'a [PacketRays],
}

impl Kernel for Segments<'_> {
    type Output = Vec<Span8>;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Vec<Span8> {
        let span = |packet: &PacketRays| {
            let (over, live) = segment(p, packet, self.own);
            Span8 {
                lo: p.to_array(over.lo),
                hi: p.to_array(p.select(live, over.hi, p.splat(-1.0))),
            }
        };
        self.packets.iter().map(span).collect()
    }
}

/// Makes the rays of some packets of a tile.
pub(super) struct Enter<'a> {
    pub view: &'a View<'a>,
    pub tile: &'a mut Tile,
    pub packets: Range<usize>,
}

impl Kernel for Enter<'_> {
    type Output = ();

    #[inline(always)]
    fn run<P: Packet>(self, p: P) {
        for packet in self.packets {
            self.tile.enter(p, self.view, packet);
        }
    }
}

/// A tile with one ray.
struct OneRay<'a> {
    ray: &'a Ray,
    domain: &'a [[f64; 3]; 2],
}

impl Kernel for OneRay<'_> {
    type Output = Tile;

    #[inline(always)]
    fn run<P: Packet>(self, p: P) -> Tile {
        let mut packet = PacketRays {
            lines: Lines::same(self.ray),
            ..PacketRays::default()
        };
        packet.record.forget();
        packet.enter(p, 1, self.domain);
        Tile {
            domain: *self.domain,
            packets: vec![packet],
            ..Tile::default()
        }
    }
}

impl Prepared for PreparedSolid<'_> {
    fn leaves(&self, isa: Isa, frame: &Frame) -> Option<Leaves> {
        let leaves = self.leaves.iter();
        let pictures: OnPictures = leaves.map(|leaf| leaf.on_picture(isa, frame)).collect();
        let any = pictures.iter().any(Option::is_some);
        any.then(|| Box::new(pictures) as Leaves)
    }

    fn survey(&self, isa: Isa, beams: WithBeams, request: &Request, findings: &mut Findings) {
        isa.run(SurveySolid {
            solid: self,
            leaves: beams.leaves,
            request,
            findings,
        });
    }

    /// Each operand may be on either side.
    fn everything(&self) -> Active {
        Active::everything(&[], 0, self.leaves.len(), &Regions::NONE)
    }

    /// A part holds no face where all of it is on one side.
    fn divide(
        &self,
        isa: Isa,
        _leaves: Option<&(dyn Any + Send + Sync)>,
        boxes: &Boxes,
    ) -> Option<Division> {
        let mut division = Division::default();
        for (place, active) in boxes.cells {
            let sides = self.sides(isa, &boxes.root.boxes(&eight(*place), boxes.level));
            let unknown = (0..8).filter(|k| sides[*k] == Side::Unknown);
            let open = unknown.fold(0, |open, k| open | 1 << k);
            // Twice for each operand, at most: over the box and at its middle.
            division.evaluations += 2 * self.leaves.len() as u64;
            division.add(*place, open, |_| active.clone());
        }
        Some(division)
    }

    fn trace(&self, job: &TileJob, known: (&Hint, &Rows), tile: &mut Tile) {
        if let Some(beams) = &job.beams {
            let cells = Cells {
                solid: self,
                job,
                beams,
                tile,
            };
            return cells.trace(known);
        }
        let wanted = tile.boxed(job.outline);
        // Elsewhere nothing is known about rays beside those that sample.
        tile.missed &= !wanted;
        for cell in 0..CELLS {
            if wanted >> cell & 1 == 0 {
                tile.counts.apart += tile.pixels(cell);
                continue;
            }
            let first = cell * PACKETS_OF_CELL;
            let packets = first..first + PACKETS_OF_CELL;
            job.isa.run(Enter {
                view: job.view,
                tile,
                packets: packets.clone(),
            });
            let look = Look {
                isa: job.isa,
                settings: job.settings,
                first_only: true,
            };
            self.faces_of(
                &look,
                job.domain,
                tile,
                packets,
                |tile, packet, lane, faces| {
                    show(job.index, tile, packet, lane, faces);
                },
            );
        }
    }

    fn normals(&self, isa: Isa, index: u16, tile: &mut Tile) {
        for (number, leaf) in (index..).zip(&self.leaves) {
            leaf.normals(isa, number, tile);
        }
    }

    fn along(&self, isa: Isa, settings: &Settings, search: &Search, first_only: bool) -> Trail {
        let Search {
            ray,
            domain,
            within,
        } = *search;
        let mut tile = isa.run(OneRay { ray, domain });
        let end = tile.packets[0].limit[0];
        if end < 0.0 {
            return Trail::default();
        }
        let mut trail = Trail {
            entry: tile.packets[0].record.entry[0],
            end: Some(end),
            ..Trail::default()
        };
        if within.is_some_and(|[first, last]| first > last) {
            return trail;
        }
        let look = Look {
            isa,
            settings,
            first_only,
        };
        self.faces_of(&look, domain, &mut tile, 0..1, |_, _, _, faces| {
            for face in faces {
                face.verdict.append(&mut trail.events);
                if first_only && face.verdict.is_certain_hit() {
                    break;
                }
            }
        });
        trail.evaluations = tile.counts;
        trail
    }
}

/// Keeps the faces of a ray, up to the first certain hit.
pub(super) fn show(first: u16, tile: &mut Tile, packet: usize, lane: usize, faces: &[Face]) {
    for face in faces {
        if keep(tile, packet, lane, face, first + face.leaf as u16) {
            break;
        }
    }
}

/// Keeps a face, as far as it is not behind what the ray shows. Is it a certain hit, behind which nothing is of interest?
/// Plain roots that are nearer than what is shown go into the record; the rest into the tile's list.
fn keep(tile: &mut Tile, packet: usize, lane: usize, face: &Face, surface: u16) -> bool {
    let rays = &mut tile.packets[packet];
    let (record, bit) = (&mut rays.record, 1 << lane);
    if let Verdict::Root { t } = face.verdict {
        let old = Interval {
            lo: record.lo[lane],
            hi: record.hi[lane],
        };
        let nearer = t.lo < old.lo;
        let apart = t.hi < old.lo || old.hi < t.lo;
        if apart {
            record.tied &= !bit;
        } else {
            record.tied |= bit;
        }
        if nearer {
            record.shown |= bit;
            (record.lo[lane], record.hi[lane]) = (t.lo, t.hi);
            record.surface[lane] = surface;
            record.tied |= u8::from(face.tied) << lane;
        }
        rays.limit[lane] = rays.limit[lane].min(t.hi);
        return true;
    }
    record.special |= bit;
    record.tied |= u8::from(face.tied && face.verdict.is_certain_hit()) << lane;
    tile.events.push(Event {
        packet: packet as u16,
        lane: lane as u8,
        surface,
        verdict: face.verdict,
    });
    if let Verdict::Crossing { t } = face.verdict {
        rays.limit[lane] = rays.limit[lane].min(t.hi);
        return true;
    }
    false
}
