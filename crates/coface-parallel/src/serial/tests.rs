//! What one thread does is what rayon does.

/// The same expressions for both kinds of iterators: what they make of some numbers, as texts.
macro_rules! expressions {
    () => {
        pub(super) fn all(items: &[u32]) -> Vec<String> {
            let mut made: Vec<String> = Vec::new();
            let mut tell = |x: &dyn std::fmt::Debug| made.push(format!("{x:?}"));
            let count = items.len();
            tell(&items.par_iter().map(|x| x / 2).collect::<Vec<_>>());
            tell(&items.par_iter().copied().filter(|x| x % 3 == 0).collect::<Vec<_>>());
            tell(&items.par_iter().filter_map(|x| x.checked_sub(9)).collect::<Vec<_>>());
            tell(&(0..count).into_par_iter().with_min_len(3).with_max_len(5).map(|i| items[i]).sum::<u32>());
            tell(&items.par_iter().zip(items).enumerate().skip(1).take(7).collect::<Vec<_>>());
            tell(&items.par_iter().rev().step_by(2).cloned().collect::<Vec<_>>());
            tell(&items.par_iter().map_init(|| 7, |seven, x| x + *seven).collect::<Vec<_>>());
            tell(&items.par_iter().flat_map_iter(|x| 0..x % 4).collect::<Vec<_>>());
            tell(&items.par_iter().flat_map(|x| vec![*x; 2]).collect::<Vec<_>>());
            tell(&items.par_iter().map(|x| vec![*x; 2]).flatten().collect::<Vec<_>>());
            tell(&items.par_iter().map(Some).flatten_iter().count());
            tell(&items.par_iter().copied().reduce(|| 3, u32::max));
            tell(&items.par_iter().fold(|| 0, |sum, x| sum + x).sum::<u32>());
            tell(&(items.par_iter().max(), items.par_iter().min(), items.par_iter().len()));
            tell(&(items.par_iter().all(|x| *x < 90), items.par_iter().any(|x| *x == 4)));
            tell(&items.par_iter().find_first(|x| **x % 5 == 1));
            tell(&items.par_iter().find_map_first(|x| x.checked_sub(50)));
            tell(&items.par_iter().map(|x| x.checked_sub(2)).collect::<Option<Vec<_>>>());
            tell(&items.par_iter().map(|x| (*x, x + 1)).unzip::<_, _, Vec<_>, Vec<_>>());
            tell(&items.par_iter().try_for_each(|x| if *x < 60 { Ok(()) } else { Err("large") }));
            tell(&items.par_chunks(4).map(<[u32]>::len).collect::<Vec<_>>());
            tell(&items.par_windows(2).map(|pair| pair[0] < pair[1]).collect::<Vec<_>>());
            let mut changed = items.to_vec();
            changed.par_iter_mut().for_each(|x| *x += 1);
            changed.par_chunks_mut(3).for_each_init(|| 1, |one, chunk| chunk[0] += *one);
            tell(&changed);
            changed.par_extend(items.par_iter().copied());
            tell(&changed);
            changed.par_sort_by_key(|x| x % 10);
            tell(&changed);
            changed.par_sort_by(|a, b| (a % 7).cmp(&(b % 7)));
            tell(&changed);
            changed.par_sort_unstable_by_key(|x| (x % 7, *x));
            tell(&changed);
            changed.par_sort_unstable_by(|a, b| b.cmp(a));
            tell(&changed);
            changed.par_sort_unstable();
            tell(&changed);
            made
        }
    };
}

mod one {
    use super::super::prelude::*;
    expressions!();
}

mod many {
    use rayon::prelude::*;
    expressions!();
}

#[test]
fn one_thread_makes_what_many_make() {
    for count in [0, 1, 2, 10, 500] {
        let items: Vec<u32> = (0..count).map(|i| (i * 37 + 11) % 83).collect();
        assert_eq!(one::all(&items), many::all(&items), "{count} items");
    }
}

#[test]
fn what_is_started_is_done_at_once() {
    let mut order = vec![0];
    super::in_place_scope(|scope| {
        scope.spawn(|_| order.push(1));
    });
    let (a, b) = super::join(|| order.len(), || 5);
    assert_eq!((a, b), (2, 5));
    let pool = super::ThreadPoolBuilder::new().num_threads(4).build().expect("a pool of no threads");
    assert_eq!(pool.install(super::current_num_threads), 1);
}
