//! Kinks that come and go.

use super::apartness::{Tube, share_nothing, share_one_knot};
use super::fitting::renamed;
use super::piece_boxes::{PieceBoxes, piece_box};
use super::smooth_pieces::Span;
use super::smooth_pieces::piece_length;
use super::{Kinks, KnotIndex};
use crate::{Curve, Order, YinSet};
use coface_algebra::{Error, ErrorKind, VertexId};

impl YinSet {
    /// The knot of the boundary where a kink is; none if there is no such kink.
    ///
    /// # Complexity
    /// $O(\log m)$ for m kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// let vertex = set.kinks().vertex(corner).expect("the corner is a kink");
    /// assert_eq!(set.vertex_to_knot(vertex), Some(corner));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertex_to_knot(&self, vertex: VertexId) -> Option<KnotIndex> {
        self.kinks().knot(vertex)
    }

    /// The point of the plane where a kink is; none if there is no such kink.
    ///
    /// # Complexity
    /// $O(\log m)$ for m kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// let vertex = set.kinks().vertex(corner).expect("the corner is a kink");
    /// assert_eq!(set.vertex_to_point(vertex), Some([1.0, 1.0]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertex_to_point(&self, vertex: VertexId) -> Option<[f64; 2]> {
        let at = self.kinks().knot(vertex)?;
        Some(self.curve(at.curve as usize).knot_point(at.knot as usize))
    }

    /// The kink at a knot; none if it is no kink. The knot after the last one of a curve is its first.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no such knot.
    ///
    /// # Complexity
    /// $O(\log m)$ for m kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// assert_eq!(set.knot_to_vertex(corner)?.map(|vertex| vertex.index()), Some(1));
    /// assert_eq!(set.knot_to_vertex(KnotIndex { curve: 0, knot: 1 })?, None);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn knot_to_vertex(&self, knot: KnotIndex) -> Result<Option<VertexId>, Error> {
        Ok(self.kinks().vertex(self.checked_knot(knot)?))
    }

    /// Makes a knot a kink and gives its vertex. The smooth piece around it becomes two; one that was periodic begins and ends there
    /// from now on. The knot after the last one of a curve is its first.
    ///
    /// No other polynomial changes in any bit, and [`Self::erase_kink`] gives back what was, bit for bit.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no such knot, if it is a kink already, or if the boundary would cross or touch itself.
    /// The set is then as it was.
    ///
    /// # Complexity
    /// $O(p \log n)$ for p knots of the smooth piece and n in all, once the boxes around all polynomials are there, which the
    /// first edit makes in $O(n)$. Where the changed piece comes near to what it does not belong to, the whole boundary is checked.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [3.0, 0.0], [4.0, 2.0], [2.0, 4.0], [-1.0, 2.0]];
    /// let smooth = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let mut set = smooth.clone();
    /// let kink = set.insert_kink(KnotIndex { curve: 0, knot: 2 })?;
    /// assert_eq!((kink.index(), set.vertex_to_point(kink)), (0, Some([4.0, 2.0])));
    /// assert_ne!(set.curve(0), smooth.curve(0));
    /// set.erase_kink(kink)?;
    /// assert_eq!(set, smooth);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn insert_kink(&mut self, knot: KnotIndex) -> Result<VertexId, Error> {
        let at = self.checked_knot(knot)?;
        if self.kinks().vertex(at).is_some() {
            return Err(self.is_kink_already(at));
        }
        let span = |ends| Span { curve: at.curve, ends };
        let (removed, added) = match self.kinks().around(at) {
            None => (vec![span(None)], vec![span(Some([at.knot; 2]))]),
            Some([before, after]) => (
                vec![span(Some([before, after]))],
                vec![span(Some([before, at.knot])), span(Some([at.knot, after]))],
            ),
        };
        self.change(&removed, &added)?;
        Ok(self.kinks_mut().insert(at))
    }

    /// Makes a kink an ordinary knot again and gives that knot. The smooth pieces beside it become one; the last kink of a curve
    /// leaves it periodic.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if there is no such kink; [`ErrorKind::InvalidInput`] if the boundary would cross or touch itself.
    /// The set is then as it was.
    ///
    /// # Complexity
    /// As [`Self::insert_kink`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let mut set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// let vertex = set.kinks().vertex(corner).expect("the corner is a kink");
    /// assert_eq!(set.erase_kink(vertex)?, corner);
    /// assert_eq!(set.kinks().len(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn erase_kink(&mut self, kink: VertexId) -> Result<KnotIndex, Error> {
        let Some(at) = self.kinks().knot(kink) else {
            return Err(Error::new(ErrorKind::NotInComplex, format!("there is no kink {kink:?}"))
                .with_cure("take the vertex of a kink that is there"));
        };
        let span = |ends| Span { curve: at.curve, ends };
        let (removed, added) = match self.kinks().around(at) {
            Some([before, after]) if before != at.knot => (
                vec![span(Some([before, at.knot])), span(Some([at.knot, after]))],
                vec![span(Some([before, after]))],
            ),
            _ => (vec![span(Some([at.knot; 2]))], vec![span(None)]),
        };
        self.change(&removed, &added)?;
        self.kinks_mut().erase(kink);
        Ok(at)
    }

    /// Makes knots kinks, all at once, and gives their vertices in the order of the knots. It is what [`Self::insert_kink`] does one after the
    /// other, but that each smooth piece is fitted once, and the boundary checked as it is in the end.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no such knot, if one is a kink already or comes twice, or if the boundary would cross or
    /// touch itself. The set is then as it was.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n pieces in all; where changed pieces come near to what they do not belong to, the whole boundary is checked.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let mut set = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let kinks = set.insert_kinks(&[3, 1, 0, 2].map(|knot| KnotIndex { curve: 0, knot }))?;
    /// assert_eq!(set.vertex_to_point(kinks[0]), Some([0.0, 2.0]));
    /// assert_eq!(set.curve(0).signed_area(), 4.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn insert_kinks(&mut self, knots: &[KnotIndex]) -> Result<Vec<VertexId>, Error> {
        if let [knot] = knots {
            return Ok(vec![self.insert_kink(*knot)?]);
        }
        let all = knots.iter().map(|&knot| self.checked_knot(knot)).collect::<Result<Vec<_>, _>>()?;
        let mut sorted = all.clone();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(twice(pair[0]));
        }
        if let Some(&at) = sorted.iter().find(|&&at| self.kinks().vertex(at).is_some()) {
            return Err(self.is_kink_already(at));
        }
        // What each smooth piece that has new kinks in it becomes.
        let mut changes: Vec<(Span, Vec<Span>)> = Vec::new();
        for on_curve in sorted.chunk_by(|a, b| a.curve == b.curve) {
            let curve = on_curve[0].curve;
            let span = |ends: [u32; 2]| Span { curve, ends: Some(ends) };
            let Some([before, _]) = self.kinks().around(on_curve[0]) else {
                let ring = |at: usize| on_curve[at % on_curve.len()].knot;
                let added = (0..on_curve.len()).map(|at| span([ring(at), ring(at + 1)])).collect();
                changes.push((Span { curve, ends: None }, added));
                continue;
            };
            // From a kink on, so that none of its pieces comes in two runs.
            let first = on_curve.partition_point(|at| at.knot < before);
            let round = on_curve[first..].iter().chain(&on_curve[..first]);
            for &at in round {
                let [before, after] = self.kinks().around(at).expect("the curve has kinks");
                match changes.last_mut() {
                    Some((whole, parts)) if *whole == span([before, after]) => {
                        let last = parts.last_mut().expect("a piece that changes becomes several");
                        let end = last.ends.replace([last.first() as u32, at.knot]);
                        parts.push(span([at.knot, end.expect("it is between kinks")[1]]));
                    }
                    _ => changes
                        .push((span([before, after]), vec![span([before, at.knot]), span([at.knot, after])])),
                }
            }
        }
        self.change_all(&changes.into_iter().map(|(whole, parts)| (vec![whole], parts)).collect::<Vec<_>>())?;
        Ok(all.into_iter().map(|at| self.kinks_mut().insert(at)).collect())
    }

    /// Makes kinks ordinary knots again, all at once, and gives the knots in the order of the kinks: as [`Self::erase_kink`] does one after
    /// the other, but that each smooth piece is fitted once, and the boundary checked as it is in the end.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if there is no such kink; [`ErrorKind::InvalidInput`] if one comes twice, or if the boundary would cross or
    /// touch itself. The set is then as it was.
    ///
    /// # Complexity
    /// As [`Self::insert_kinks`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let smooth = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let mut set = smooth.clone();
    /// let kinks = set.insert_kinks(&[3, 1].map(|knot| KnotIndex { curve: 0, knot }))?;
    /// assert_eq!(set.erase_kinks(&kinks)?.iter().map(|at| at.knot).collect::<Vec<_>>(), [3, 1]);
    /// assert_eq!(set, smooth);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn erase_kinks(&mut self, kinks: &[VertexId]) -> Result<Vec<KnotIndex>, Error> {
        if let [kink] = kinks {
            return Ok(vec![self.erase_kink(*kink)?]);
        }
        let knot = |&kink: &VertexId| {
            self.kinks().knot(kink).ok_or_else(|| {
                Error::new(ErrorKind::NotInComplex, format!("there is no kink {kink:?}"))
                    .with_cure("take the vertex of a kink that is there")
            })
        };
        let all = kinks.iter().map(knot).collect::<Result<Vec<_>, _>>()?;
        let mut sorted = all.clone();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(twice(pair[0]));
        }
        let mut changes: Vec<(Vec<Span>, Vec<Span>)> = Vec::new();
        for on_curve in sorted.chunk_by(|a, b| a.curve == b.curve) {
            let curve = on_curve[0].curve;
            let span = |ends: [u32; 2]| Span { curve, ends: Some(ends) };
            let old: Vec<u32> = self.kinks().on_curve(curve).collect();
            let is_erased = |knot: u32| on_curve.binary_search(&KnotIndex { curve, knot }).is_ok();
            let pieces = |from: usize, count: usize| -> Vec<Span> {
                let ring = |at: usize| old[at % old.len()];
                (from..from + count).map(|at| span([ring(at), ring(at + 1)])).collect()
            };
            let Some(first) = old.iter().position(|&knot| !is_erased(knot)) else {
                changes.push((pieces(0, old.len()), vec![Span { curve, ends: None }]));
                continue;
            };
            // From a kink that stays to the next.
            let stay: Vec<usize> =
                (first..=first + old.len()).filter(|&at| !is_erased(old[at % old.len()])).collect();
            for pair in stay.windows(2).filter(|pair| pair[1] > pair[0] + 1) {
                let ends = [pair[0], pair[1]].map(|at| old[at % old.len()]);
                changes.push((pieces(pair[0], pair[1] - pair[0]), vec![span(ends)]));
            }
        }
        self.change_all(&changes)?;
        kinks.iter().for_each(|&kink| self.kinks_mut().erase(kink));
        Ok(all)
    }

    /// Makes several changes, or none of them.
    fn change_all(&mut self, changes: &[(Vec<Span>, Vec<Span>)]) -> Result<(), Error> {
        let before = self.clone();
        for (removed, added) in changes {
            if let Err(error) = self.change(removed, added) {
                *self = before;
                return Err(error);
            }
        }
        Ok(())
    }

    fn is_kink_already(&self, at: KnotIndex) -> Error {
        let KnotIndex { curve, knot } = at;
        let vertex = self.kinks().vertex(at).map_or(String::new(), |vertex| format!(": {vertex:?}"));
        Error::invalid(format!("knot {knot} of curve {curve} is a kink already{vertex}"))
            .with_cure("insert kinks at other knots")
    }

    /// Takes these knots as the only kinks, named 0, 1, 2, ... as they rise, and fits all curves again. The knot after the last one of
    /// a curve is its first.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no such knot, if one is given twice, or if the boundary would cross or touch itself.
    /// The set is then as it was.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n pieces, and a check of the whole boundary where parts of it are close.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let mut set = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// set.reset_all_kinks(&[3, 1, 0, 2].map(|knot| KnotIndex { curve: 0, knot }))?;
    /// assert_eq!(set.curve(0).signed_area(), 4.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reset_all_kinks(&mut self, knots: &[KnotIndex]) -> Result<(), Error> {
        let mut sorted = knots.iter().map(|&knot| self.checked_knot(knot)).collect::<Result<Vec<_>, _>>()?;
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(twice(pair[0]));
        }
        let ends = self.kinks().pieces.ends().clone();
        let mut kinks = Kinks::new(sorted);
        kinks.pieces.set_ends(&ends);
        if self.order() == Order::LINEAR {
            *self.kinks_mut() = kinks;
            return Ok(());
        }
        let mut refitted = Vec::with_capacity(self.curve_count());
        for own in 0..self.curve_count() as u32 {
            let curve = self.curve(own as usize);
            let on_curve: Vec<u32> = kinks.on_curve(own).collect();
            let mut controls = curve.controls().to_vec();
            let spans = match &on_curve[..] {
                [] => vec![Span { curve: own, ends: None }],
                own_kinks => (0..own_kinks.len())
                    .map(|at| [own_kinks[at], own_kinks[(at + 1) % own_kinks.len()]])
                    .map(|ends| Span { curve: own, ends: Some(ends) })
                    .collect(),
            };
            for span in spans {
                let found =
                    span.fit(&curve, &ends).map_err(|error| renamed(&error, &format!("curve {own}")))?;
                write(&mut controls, curve.order(), span.first(), &found);
            }
            refitted.push(Curve::from_controls(curve.order(), controls, curve.knots().to_vec())?);
        }
        let mut set = Self::of_curves(self.order(), &refitted)?;
        self.check_side(&set)?;
        *set.kinks_mut() = kinks;
        *self = set;
        Ok(())
    }

    /// A set of closed curves of one order, without kinks.
    ///
    /// The polygons through the knots are decided exactly; where the curves surely stay apart on the way from there they lie alike.
    pub(super) fn of_curves(order: Order, curves: &[Curve<'_>]) -> Result<Self, Error> {
        if curves.is_empty() {
            return Ok(Self::empty(order));
        }
        if order != Order::LINEAR
            && let Some(set) = Self::around_polygons(order, curves)?
        {
            return Ok(set);
        }
        Self::new(curves)
    }

    fn around_polygons(order: Order, curves: &[Curve<'_>]) -> Result<Option<Self>, Error> {
        let polygons = curves
            .iter()
            .map(|curve| {
                Curve::polyline(&(0..=curve.piece_count()).map(|at| curve.knot_point(at)).collect::<Vec<_>>())
            })
            .collect::<Result<Vec<_>, _>>()?;
        let Ok(lying) = Self::new(&polygons) else { return Ok(None) };
        let straight = polygons.iter().map(|polygon| polygon.raised(order)).collect::<Result<Vec<_>, _>>()?;
        let forest = lying.forest();
        let parents = (0..curves.len()).map(|own| forest.parent(own).map(|parent| parent as u32)).collect();
        let set = Self::of_known_curves(order, curves, !lying.is_bounded(), parents);
        let old = Self::of_known_curves(order, &straight, false, vec![None; curves.len()]);
        let (arena, old) = (set.arena(), old.arena());
        let piece = |at: usize| {
            let (curve, own) = arena.curve_of_piece(at);
            Tube::new(old.curve(curve).piece(own), arena.curve(curve).piece(own))
        };
        let tubes: Vec<Tube> = (0..arena.piece_count()).map(piece).collect();
        let boxes = PieceBoxes::new(tubes.iter().map(Tube::bounds));
        let stays = (0..tubes.len())
            .all(|at| set.stays_apart(at, &tubes[at], &boxes, |other| (other < at).then(|| tubes[other])));
        Ok(stays.then_some(set))
    }

    fn of_known_curves(
        order: Order,
        curves: &[Curve<'_>],
        is_unbounded: bool,
        parents: Vec<Option<u32>>,
    ) -> Self {
        let mut arena = crate::set::CurveArena::new(order);
        curves.iter().for_each(|curve| arena.push(curve));
        Self::from_parts(arena, is_unbounded, parents, Vec::new())
    }

    /// The knot, with the one after the last of its curve as the first.
    fn checked_knot(&self, at: KnotIndex) -> Result<KnotIndex, Error> {
        let KnotIndex { curve, knot } = at;
        if curve as usize >= self.curve_count() {
            return Err(Error::invalid(format!("there is no curve {curve}")).with_cure(
                match self.curve_count() {
                    0 => "sets without boundary have no knots".to_owned(),
                    count => format!("the curves are 0 to {}", count - 1),
                },
            ));
        }
        let count = self.curve(curve as usize).piece_count() as u32;
        match knot {
            knot if knot < count => Ok(at),
            knot if knot == count => Ok(KnotIndex { curve, knot: 0 }),
            _ => Err(Error::invalid(format!("there is no knot {knot} on curve {curve}"))
                .with_cure(format!("the knots are 0 to {}", count - 1))),
        }
    }

    /// Replaces smooth pieces by others over the same knots.
    fn change(&mut self, removed: &[Span], added: &[Span]) -> Result<(), Error> {
        if self.order() == Order::LINEAR {
            return Ok(());
        }
        let own = removed[0].curve as usize;
        let curve = self.curve(own);
        let (order, count) = (curve.order(), curve.piece_count());
        let pieces = &self.kinks().pieces;
        let mut new = Vec::with_capacity(added.len());
        for span in added {
            let found = pieces.shape(span, &curve).map_err(|error| {
                let said = format!("the smooth piece of curve {own} that begins at knot {}", span.first());
                renamed(&error, &said)
            })?;
            new.push((span.first(), found));
        }
        let old: Vec<_> = removed.iter().map(|span| (span.first(), span.controls(&curve))).collect();
        let kept: Vec<bool> = removed
            .iter()
            .zip(&old)
            .map(|(span, (_, controls))| pieces.is_own(span, &curve, controls))
            .collect();
        let mut tubes = vec![None; count.min(removed.iter().map(|span| span.length(count)).sum())];
        let start = removed[0].first();
        self.write_all(own, &new);
        let degree = order.degree();
        for (first, controls) in &old {
            for at in 0..controls.len() / degree {
                let piece = (first + at) % count;
                let place = piece_length(start, piece, count) % count;
                let new = self.curve(own);
                tubes[place] = Some(Tube::new(&controls[at * degree..=(at + 1) * degree], new.piece(piece)));
            }
        }
        let tubes: Vec<Tube> =
            tubes.into_iter().map(|tube| tube.expect("the spans cover their pieces")).collect();
        if let Err(error) = self.accept(own, start, &tubes) {
            self.write_all(own, &old);
            return Err(renamed(&error, &format!("curve {own} with this change")));
        }
        let pieces = &mut self.kinks_mut().pieces;
        added.iter().for_each(|span| pieces.forget(span));
        for ((span, (_, controls)), is_own) in removed.iter().zip(old).zip(kept) {
            if is_own {
                pieces.remember(*span, controls);
            }
        }
        Ok(())
    }

    /// Checks what a curve has become where it changed, from a knot on, and notes it.
    fn accept(&mut self, own: usize, start: usize, tubes: &[Tube]) -> Result<(), Error> {
        let arena = self.arena();
        let first = arena.first_piece(own);
        let count = self.curve(own).piece_count();
        let place = |step: usize| first + (start + step) % count;
        let mut boxes = match self.kinks_mut().pieces.boxes.take() {
            Some(boxes) => boxes,
            None => {
                let arena = self.arena();
                let bounds = arena.iter().flat_map(|curve| {
                    (0..curve.piece_count()).map(|piece| piece_box(curve.piece(piece))).collect::<Vec<_>>()
                });
                PieceBoxes::new(bounds.collect::<Vec<_>>().into_iter())
            }
        };
        for (step, tube) in tubes.iter().enumerate() {
            boxes.set(place(step), tube.bounds());
        }
        let stays = (0..tubes.len()).all(|step| {
            self.stays_apart(place(step), &tubes[step], &boxes, |other| {
                let changed = (other >= first && other < first + count)
                    .then(|| (other - first + count - start) % count)
                    .filter(|&at| at < tubes.len());
                match changed {
                    Some(at) => (at < step).then(|| tubes[at]),
                    None => {
                        let (curve, piece) = self.arena().curve_of_piece(other);
                        let curve = self.curve(curve);
                        Some(Tube::new(curve.piece(piece), curve.piece(piece)))
                    }
                }
            })
        });
        if !stays {
            let curves: Vec<Curve<'_>> = (0..self.curve_count()).map(|own| self.curve(own)).collect();
            let found = Self::new(&curves)?;
            self.check_side(&found)?;
            drop(curves);
            self.take_forest(found);
        }
        let curve = self.curve(own);
        for step in 0..tubes.len() {
            boxes.set(place(step), piece_box(curve.piece((start + step) % count)));
        }
        self.kinks_mut().pieces.boxes = Some(boxes);
        Ok(())
    }

    /// Whether the tube of a piece surely meets no other but its neighbors at the common knot, and itself nowhere. Tubes that are not
    /// given are looked at elsewhere.
    fn stays_apart(
        &self,
        at: usize,
        tube: &Tube,
        boxes: &PieceBoxes,
        other_tube: impl Fn(usize) -> Option<Tube>,
    ) -> bool {
        let (curve, piece) = self.arena().curve_of_piece(at);
        let first = self.arena().first_piece(curve);
        let count = self.curve(curve).piece_count();
        let [next, last] = [1, count - 1].map(|step| first + (piece + step) % count);
        // Two pieces between two knots, or one, are neighbors twice.
        count > 2
            && tube.is_simple()
            && boxes.all_meeting(&tube.bounds(), |other| {
                other == at
                    || other_tube(other).is_none_or(|found| match other {
                        other if other == next => share_one_knot(tube, &found),
                        other if other == last => share_one_knot(&found, tube),
                        _ => share_nothing(tube, &found),
                    })
            })
    }

    fn check_side(&self, changed: &Self) -> Result<(), Error> {
        if self.is_bounded() == changed.is_bounded() {
            return Ok(());
        }
        Err(Error::invalid("the boundary would turn inside out")
            .with_cure("keep kinks where the boundary turns much"))
    }

    fn write_all(&mut self, own: usize, shapes: &[(usize, Vec<[f64; 2]>)]) {
        let order = self.order();
        let controls = self.arena_mut().controls_mut(own);
        for (first, shape) in shapes {
            write(controls, order, *first, shape);
        }
    }
}

fn twice(KnotIndex { curve, knot }: KnotIndex) -> Error {
    Error::invalid(format!("kink {knot} of curve {curve} is given twice")).with_cure("give each kink once")
}

/// Writes the control points of a smooth piece that begins at a knot, but those at knots, which never change.
fn write(controls: &mut [[f64; 2]], order: Order, first: usize, shape: &[[f64; 2]]) {
    let degree = order.degree();
    let all = controls.len() - 1;
    for (step, control) in shape.iter().enumerate().filter(|(step, _)| step % degree != 0) {
        controls[(first * degree + step) % all] = *control;
    }
}
