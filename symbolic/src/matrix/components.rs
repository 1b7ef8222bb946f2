//! Connected components.

/// The connected components of so many nodes, each in ascending order, in the order of their first nodes.
pub(crate) fn components(
    count: usize,
    are_connected: impl Fn(usize, usize) -> bool,
) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..count).collect();
    let mut components = Vec::new();
    while let Some(first) = left.first().copied() {
        let mut component = vec![first];
        left.remove(0);
        let mut next = 0;
        while let Some(node) = component.get(next).copied() {
            let is_found = |other: &usize| are_connected(node, *other);
            component.extend(left.iter().copied().filter(is_found));
            left.retain(|other| !is_found(other));
            next += 1;
        }
        component.sort_unstable();
        components.push(component);
    }
    components
}
