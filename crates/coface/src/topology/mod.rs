//! Questions that any chain complex can be asked.
