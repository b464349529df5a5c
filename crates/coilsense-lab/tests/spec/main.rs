//! Specs as people write them: what is wrong with one is said in a line, and nothing that anybody sends makes the reader fall over.
//!
//! | file | holds |
//! |---|---|
//! | `springs`, `conditions`, `sensors` | tables of faults, each with its message |
//! | `files` | what cannot be read from disk |
//! | `keys` | that what is documented is what is read, with every template, material and sensor class |
//! | `placed` | that a refusal stands at the line of its key |
//! | `hostile` | random edits and random trees, read and simulated |
//! | `mutated` | every example, of which a few bytes or words are changed |
//! | `fixtures` | the good specs |

mod conditions;
mod files;
mod fixtures;
mod hostile;
mod keys;
mod mutated;
mod placed;
mod sections;
mod sensors;
mod springs;
