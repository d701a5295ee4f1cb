//! How shells lie to each other, and which way they look.

use super::composites;
use super::containment::{shells_around, volume_sign};
use super::faults::Collector;
use super::meetings::MeetingFaces;
use super::rings::{Points, Triangles};
use super::shells::Shells;
use super::touching_shells::TouchingShells;
use super::triangle_pairs::Meeting;
use super::{CheckedFaces, CheckedPrimitive, FaultCode, FaultPlace, FaultScope};
use coface_algebra::{RaggedArray, Sign, UnionFind};
use std::cmp::Ordering;

/// More shells or triangles than these that touch each other are not arranged.
const MOST_TOUCHING: [usize; 2] = [1000, 200_000];

/// All that is known before solids are examined.
pub(super) struct Solids<'a> {
    pub(super) points: &'a Points<'a>,
    pub(super) faces: &'a CheckedFaces,
    pub(super) triangles: &'a Triangles,
    pub(super) shell_of_face: &'a [u32],
    pub(super) pieces_of_shell: &'a [u32],
    pub(super) shells: &'a Shells,
    /// The pairs of faces of different shells.
    pub(super) meetings: &'a [MeetingFaces],
    pub(super) triangles_of_shell: &'a RaggedArray,
}

/// Two shells that meet, the lower first.
struct MeetingShells {
    shells: [u32; 2],
    worst: MeetingFaces,
}

/// Shells that touch each other, rising, with the cells that they cut space into.
struct Group {
    members: Vec<u32>,
    cells: TouchingShells,
}

impl Group {
    fn position(&self, shell: u32) -> Option<u32> {
        self.members.binary_search(&shell).ok().map(|position| position as u32)
    }
}

impl Solids<'_> {
    /// Examines shells and solids; the number of shells whose position was not examined.
    pub(super) fn examine(&self, faults: &mut Collector) -> usize {
        let outward = self.outward();
        let meeting = self.meeting_shells();
        let crossing: Vec<[u32; 2]> = meeting
            .iter()
            .filter(|pair| pair.worst.meeting != Meeting::Touch)
            .map(|pair| pair.shells)
            .collect();
        for pair in meeting.iter().filter(|pair| pair.worst.meeting != Meeting::Touch) {
            self.intersection(pair, faults);
        }
        let (groups, left_out) = self.groups(&meeting);
        let mut group_of_shell = vec![u32::MAX; self.shells.shells.len()];
        for (group, number) in groups.iter().zip(0..) {
            group.members.iter().for_each(|&shell| group_of_shell[shell as usize] = number);
        }
        let around = self.around(&meeting, &groups, &group_of_shell);
        if self.faces.shell_of_face().is_some() {
            self.given_solids(&outward, &crossing, (&groups, &group_of_shell), &around, faults);
        } else {
            self.nested_shells(&outward, &crossing, &groups, &around, faults);
        }
        let is_sound = |shell| self.is_sound(shell);
        let place = |shells: &[u32]| self.shell_place(shells);
        let coherent = |shell| self.coherent(shell);
        left_out + composites::examine(self.points, self.faces, is_sound, coherent, place, faults)
    }

    fn is_sound(&self, shell: u32) -> bool {
        self.shells.shells[shell as usize].is_sound
    }

    /// The directions in which the faces of sound shells look outwards: plus where the first of them does.
    fn outward(&self) -> Vec<Option<Sign>> {
        let sign = |(shell, own): (usize, &[u32])| {
            if !self.is_sound(shell as u32) {
                return None;
            }
            let signed = own.iter().map(|&triangle| {
                let face = self.triangles.face[triangle as usize] as usize;
                (self.triangles.corners[triangle as usize], self.shells.direction[face])
            });
            match volume_sign(self.points, signed) {
                Ordering::Greater => Some(Sign::Plus),
                Ordering::Less => Some(Sign::Minus),
                Ordering::Equal => None,
            }
        };
        self.triangles_of_shell.iter().enumerate().map(sign).collect()
    }

    fn meeting_shells(&self) -> Vec<MeetingShells> {
        let mut pairs: Vec<MeetingShells> = self
            .meetings
            .iter()
            .map(|&worst| {
                let [a, b] = worst.faces.map(|face| self.shell_of_face[face as usize]);
                MeetingShells { shells: [a.min(b), a.max(b)], worst }
            })
            .collect();
        pairs.sort_by_key(|pair| (pair.shells, pair.worst.meeting, pair.worst.faces));
        pairs.dedup_by_key(|pair| pair.shells);
        pairs
    }

    /// Shells that cross, or have a part of a face in common.
    fn intersection(&self, pair: &MeetingShells, faults: &mut Collector) {
        let is_closed = pair.shells.iter().all(|&shell| self.shells.shells[shell as usize].is_closed);
        let code = match pair.worst.meeting {
            _ if is_closed && self.are_same(pair.shells) => FaultCode::DuplicateShells,
            _ if is_closed => FaultCode::ShellsIntersect,
            Meeting::Cross => FaultCode::FacesCross,
            Meeting::OverlapReversed => FaultCode::ZeroThickness,
            Meeting::Overlap | Meeting::Touch => FaultCode::FacesOverlap,
        };
        let place = FaultPlace {
            faces: pair.worst.faces.to_vec(),
            shells: pair.shells.to_vec(),
            ..FaultPlace::default()
        };
        faults.add(code, FaultScope::Surface, place);
    }

    /// Whether two shells have the same faces: each with sides between the same points, whichever way they run and wherever they begin.
    fn are_same(&self, shells: [u32; 2]) -> bool {
        let [first, second] = shells.map(|shell| {
            let own = self.shells.shells[shell as usize].faces.iter();
            let mut faces: Vec<Vec<[u32; 2]>> = own.map(|&face| self.sides_of_face(face as usize)).collect();
            faces.sort_unstable();
            faces
        });
        first == second
    }

    /// The sides of all rings of a face as pairs of places, the lower one first, rising.
    fn sides_of_face(&self, face: usize) -> Vec<[u32; 2]> {
        let mut sides = Vec::new();
        for ring in self.faces.rings_of_face(face) {
            let ring = self.faces.rings().list(ring);
            for (i, &from) in ring.iter().enumerate() {
                let [a, b] =
                    [from, ring[(i + 1) % ring.len()]].map(|vertex| self.points.place[vertex as usize]);
                sides.push([a.min(b), a.max(b)]);
            }
        }
        sides.sort_unstable();
        sides
    }

    /// The groups of sound shells that touch, and how many shells are in groups that are too large.
    fn groups(&self, meeting: &[MeetingShells]) -> (Vec<Group>, usize) {
        let mut union = UnionFind::new(self.shells.shells.len());
        let mut touching: Vec<u32> = Vec::new();
        for pair in meeting.iter().filter(|pair| pair.worst.meeting == Meeting::Touch) {
            if pair.shells.iter().all(|&shell| self.is_sound(shell)) {
                union.unite(pair.shells[0], pair.shells[1]);
                touching.extend(pair.shells);
            }
        }
        touching.sort_unstable();
        touching.dedup();
        touching.sort_by_key(|&shell| union.find(shell));
        let (mut groups, mut left_out) = (Vec::new(), 0);
        for own in touching.chunk_by(|&a, &b| union.find(a) == union.find(b)) {
            let triangles: Vec<Vec<[u32; 3]>> = own.iter().map(|&shell| self.coherent(shell)).collect();
            let size = triangles.iter().map(Vec::len).sum::<usize>();
            let is_large = own.len() > MOST_TOUCHING[0] || size > MOST_TOUCHING[1];
            match TouchingShells::new(self.points, if is_large { &[] } else { &triangles }) {
                Ok(cells) if !is_large => groups.push(Group { members: own.to_vec(), cells }),
                _ => left_out += own.len(),
            }
        }
        (groups, left_out)
    }

    /// The triangles of a shell, running coherently.
    fn coherent(&self, shell: u32) -> Vec<[u32; 3]> {
        let coherent = |&triangle: &u32| {
            let [a, b, c] = self.triangles.corners[triangle as usize];
            let face = self.triangles.face[triangle as usize];
            let is_reversed = self.shells.direction[face as usize] == Sign::Minus;
            if is_reversed { [a, c, b] } else { [a, b, c] }
        };
        self.triangles_of_shell.list(shell as usize).iter().map(coherent).collect()
    }

    /// The shells around each sound shell, rising.
    fn around(&self, meeting: &[MeetingShells], groups: &[Group], group_of_shell: &[u32]) -> Vec<Vec<u32>> {
        let count = self.shells.shells.len();
        let mut around = vec![Vec::new(); count];
        let sound: Vec<u32> = (0..count as u32).filter(|&shell| self.is_sound(shell)).collect();
        if sound.is_empty() || count < 2 {
            return around;
        }
        let corner = |&shell: &u32| {
            let triangle = self.triangles_of_shell.list(shell as usize)[0];
            self.triangles.corners[triangle as usize][0]
        };
        let places: Vec<u32> = sound.iter().map(corner).collect();
        let is_asked = |number: usize, other: u32| {
            let own = sound[number];
            let group = group_of_shell[own as usize];
            let is_near = group != u32::MAX && group == group_of_shell[other as usize];
            let pair = [own.min(other), own.max(other)];
            own != other
                && self.shells.shells[other as usize].is_even
                && !is_near
                && meeting.binary_search_by_key(&pair, |meeting| meeting.shells).is_err()
        };
        let lists = shells_around(self.points, self.triangles, self.shell_of_face, &places, is_asked);
        for (&shell, mut list) in sound.iter().zip(lists) {
            if let Some(group) = groups.get(group_of_shell[shell as usize] as usize)
                && let Some(own) = group.position(shell)
            {
                let is_inside = |&other: &u32| {
                    group.position(other).is_some_and(|other| {
                        // All of it is in the other, which has more.
                        matches!(group.cells.relation(own, other), [true, false, true])
                    })
                };
                list.extend(group.members.iter().filter(|&&other| other != shell && is_inside(&other)));
                list.sort_unstable();
            }
            around[shell as usize] = list;
        }
        around
    }

    fn shell_place(&self, shells: &[u32]) -> FaultPlace {
        let first = |&shell: &u32| self.shells.shells[shell as usize].faces.first().copied();
        FaultPlace {
            faces: shells.iter().filter_map(first).collect(),
            shells: shells.to_vec(),
            ..FaultPlace::default()
        }
    }

    /// Faces that look the wrong way where others of the shell look the right way, or the whole shell.
    fn orientation(
        &self,
        shell: u32,
        outward: Sign,
        looks_out: bool,
        scope: FaultScope,
        faults: &mut Collector,
    ) {
        let right = if looks_out { outward } else { outward.opposite() };
        let faces = &self.shells.shells[shell as usize].faces;
        let is_wrong = |&&face: &&u32| self.shells.direction[face as usize] != right;
        let wrong = faces.iter().filter(is_wrong).count();
        if wrong == faces.len() {
            faults.add(FaultCode::ShellOrientation, scope, self.shell_place(&[shell]));
        } else {
            for &face in faces.iter().filter(is_wrong) {
                faults.add_with(FaultCode::FaceOrientation, FaultScope::Surface, || FaultPlace {
                    faces: vec![face],
                    ..FaultPlace::default()
                });
            }
        }
    }

    /// Shells that are components: those at even depth bound solids, the others voids.
    fn nested_shells(
        &self,
        outward: &[Option<Sign>],
        crossing: &[[u32; 2]],
        groups: &[Group],
        around: &[Vec<u32>],
        faults: &mut Collector,
    ) {
        let mut outer_count = 0;
        for (number, shell) in self.shells.shells.iter().enumerate() {
            let is_outer = around[number].len().is_multiple_of(2);
            if is_outer && !shell.faces.is_empty() {
                outer_count += 1;
                if outer_count > 1 {
                    faults.add_with(FaultCode::SeveralPieces, FaultScope::Solid, || {
                        self.shell_place(&[number as u32])
                    });
                }
            }
            if let Some(outward) = outward[number] {
                let scope = if is_outer { FaultScope::Surface } else { FaultScope::Solid };
                self.orientation(number as u32, outward, is_outer, scope, faults);
            }
        }
        for group in groups {
            for (own, &shell) in (0..).zip(&group.members) {
                for (other, &second) in (0..own).zip(&group.members) {
                    let is_known = crossing.binary_search(&[second, shell]).is_ok();
                    if !is_known && group.cells.relation(other, own) == [true; 3] {
                        let place = self.shell_place(&[second, shell]);
                        faults.add(FaultCode::ShellsIntersect, FaultScope::Surface, place);
                    }
                }
                let ancestors: Vec<u32> =
                    around[shell as usize].iter().filter_map(|&other| group.position(other)).collect();
                let is_own = |cell: &&Vec<u32>| {
                    cell.len() == ancestors.len() + 1
                        && cell.contains(&own)
                        && ancestors.iter().all(|ancestor| cell.contains(ancestor))
                };
                let is_outer = around[shell as usize].len().is_multiple_of(2);
                if is_outer && group.cells.cells.iter().filter(is_own).count() > 1 {
                    faults.add(FaultCode::SolidDisconnected, FaultScope::Solid, self.shell_place(&[shell]));
                }
            }
        }
    }

    /// Solids whose shells are given: the first of each is its outer shell.
    fn given_solids(
        &self,
        outward: &[Option<Sign>],
        crossing: &[[u32; 2]],
        (groups, group_of_shell): (&[Group], &[u32]),
        around: &[Vec<u32>],
        faults: &mut Collector,
    ) {
        for (shell, &pieces) in self.pieces_of_shell.iter().enumerate() {
            if self.faces.primitive_of_shell(shell) == CheckedPrimitive::MultiSurface {
                continue;
            }
            (1..pieces).for_each(|_| {
                faults.add_with(FaultCode::SeveralPieces, FaultScope::Solid, || {
                    self.shell_place(&[shell as u32])
                });
            });
        }
        let solid_of_shell = self.faces.solid_of_shell();
        let mut shells: Vec<u32> = (0..solid_of_shell.len() as u32).collect();
        shells.sort_by_key(|&shell| solid_of_shell[shell as usize]);
        for own in shells.chunk_by(|&a, &b| solid_of_shell[a as usize] == solid_of_shell[b as usize]) {
            let outer = own[0];
            for (position, &shell) in own.iter().enumerate() {
                if let Some(outward) = outward[shell as usize] {
                    self.orientation(shell, outward, position == 0, FaultScope::Surface, faults);
                }
                if position == 0 || !self.is_sound(shell) {
                    continue;
                }
                for &other in own[..position].iter().filter(|&&other| self.is_sound(other)) {
                    let pair = [shell.min(other), shell.max(other)];
                    if crossing.binary_search(&pair).is_err() {
                        let number = group_of_shell[shell as usize];
                        let group = groups.get(number as usize);
                        let code = relation(group, around, shell, other, outer);
                        if let Some(code) = code {
                            faults.add(code, FaultScope::Solid, self.shell_place(&pair));
                        }
                    }
                }
            }
            let group = groups.get(group_of_shell[outer as usize] as usize);
            if let Some((group, position)) = group.and_then(|group| Some((group, group.position(outer)?))) {
                let is_inside = |cell: &&Vec<u32>| cell[..] == [position];
                if group.cells.cells.iter().filter(is_inside).count() > 1 {
                    faults.add(FaultCode::SolidDisconnected, FaultScope::Solid, self.shell_place(&[outer]));
                }
            }
        }
    }
}

/// What is wrong between an inner shell and another shell of its solid; they may be of one group.
fn relation(
    group: Option<&Group>,
    around: &[Vec<u32>],
    shell: u32,
    other: u32,
    outer: u32,
) -> Option<FaultCode> {
    let together =
        group.and_then(|group| Some(group.cells.relation(group.position(shell)?, group.position(other)?)));
    let [both, shell_only, other_only] = together.unwrap_or_else(|| {
        let is_in = around[shell as usize].binary_search(&other).is_ok();
        let is_around = around[other as usize].binary_search(&shell).is_ok();
        [is_in || is_around, !is_in, !is_around]
    });
    match (other == outer, both) {
        (true, true) if !shell_only && other_only => None,
        (_, true) => Some(FaultCode::ShellsIntersect),
        (true, false) => Some(FaultCode::InnerShellOutside),
        (false, false) => None,
    }
}
