//! What the programs ask of the machine on which they run: files, git, and the terminal.
//!
//! Everything here may meet something hostile: a folder by somebody else, a disk that is full, a terminal of one column.
//! So each question has one answer, in one place, for all commands.

pub mod files;
pub mod git;
pub mod layout;
pub mod printable;
pub mod terminal;
