//! The builder on this book: its ledger's pages, its keys, its data.

mod ledger_pages;
mod open_claims;
mod pages;
mod placeholders;
mod records;
