//! `proofread lsp`: findings for an editor while a text is written, by the Language Server Protocol on standard input and output.
//!
//! One thread reads, one checks, and this one answers, so a long check keeps no message waiting. The messages are few and
//! their forms simple, so they are read and written as JSON: the libraries for them would add a third to the time of the
//! installation, and end at the first message that is malformed.

mod buffers;
mod checking;
mod debounce;
mod findings;
mod framing;
mod languages;
mod positions;
mod session;
mod settings;

use checking::{CheckJob, CheckOutcome, Checker};
use framing::{Incoming, read_message, write_message};
use geneva_host::printable::in_words;
use session::Session;
use std::io::IsTerminal;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Instant;

/// What happens to a session.
enum Event {
    Incoming(Incoming),
    Checked(Box<CheckOutcome>),
    /// The editor has closed its end, or the check has come to an end that it should not have.
    Ended,
}

/// Serves the editor at the other end of standard input and output until it asks for the end; the answer is whether it asked
/// for it as it should.
///
/// # Errors
///
/// If standard input is a terminal, or standard output cannot be written to.
pub(super) fn serve() -> Result<bool, String> {
    if std::io::stdin().is_terminal() {
        return Err("standard input is a terminal, but `lsp` is started by an editor, which writes messages to it; \
                    to check a file that is named lsp, give ./lsp and --input"
            .to_owned());
    }
    let (events, happened) = channel();
    let (jobs, due) = channel();
    spawn("reader", reader(events.clone()))?;
    spawn("checker", checker(due, events))?;
    answer(&happened, &jobs)
}

/// As much stack as the main thread of a program has: formulas nest.
const STACK: usize = 8 << 20;

fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> Result<(), String> {
    let started = thread::Builder::new().name(name.to_owned()).stack_size(STACK).spawn(work);
    started.map(drop).map_err(|why| format!("cannot start a thread: {}", in_words(&why)))
}

/// Hands on what the editor writes.
fn reader(events: Sender<Event>) -> impl FnOnce() + Send + 'static {
    move || {
        let mut stream = std::io::stdin().lock();
        while let Ok(Some(incoming)) = read_message(&mut stream) {
            if events.send(Event::Incoming(incoming)).is_err() {
                return;
            }
        }
        // Nobody listens any more if this fails.
        let _ = events.send(Event::Ended);
    }
}

/// Checks what is due.
fn checker(due: Receiver<CheckJob>, events: Sender<Event>) -> impl FnOnce() + Send + 'static {
    /// Tells that nothing is checked any more, however that came.
    struct EndTeller(Sender<Event>);

    impl Drop for EndTeller {
        fn drop(&mut self) {
            let _ = self.0.send(Event::Ended);
        }
    }

    move || {
        let teller = EndTeller(events);
        let mut checker = Checker::default();
        for job in due {
            if teller.0.send(Event::Checked(Box::new(checker.check(&job)))).is_err() {
                return;
            }
        }
    }
}

fn answer(happened: &Receiver<Event>, jobs: &Sender<CheckJob>) -> Result<bool, String> {
    let mut session = Session::default();
    let mut output = std::io::stdout().lock();
    loop {
        let event = match session.next_due() {
            Some(due) => match happened.recv_timeout(due.saturating_duration_since(Instant::now())) {
                Err(RecvTimeoutError::Timeout) => None,
                Ok(event) => Some(event),
                Err(RecvTimeoutError::Disconnected) => Some(Event::Ended),
            },
            None => Some(happened.recv().unwrap_or(Event::Ended)),
        };
        // All that has come in counts before a check begins.
        for event in event.into_iter().chain(happened.try_iter()) {
            match event {
                Event::Incoming(incoming) => session.take(incoming, Instant::now()),
                Event::Checked(outcome) => session.take_outcome(*outcome, Instant::now()),
                Event::Ended => session.end(),
            }
            if session.ended().is_some() {
                break;
            }
        }
        for message in session.take_outgoing() {
            write_message(&mut output, &message)
                .map_err(|why| format!("cannot write to standard output: {}", in_words(&why)))?;
        }
        if let Some(well) = session.ended() {
            return Ok(well);
        }
        if let Some(job) = session.next_job(Instant::now()) {
            // If it cannot be sent, the checker has ended, and says so.
            let _ = jobs.send(job);
        }
    }
}
