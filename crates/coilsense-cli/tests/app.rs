//! `coilsense app`: the real binary, asked over a socket as a browser and as somebody with other intentions would.
//!
//! With a page in it (`cargo xtask page`, then `--features app`) it is served; without, the command says how to get one.

#[cfg(page_is_built)]
mod answering;

#[cfg(not(page_is_built))]
use std::process::Command;

#[cfg(not(page_is_built))]
#[test]
fn a_command_without_a_page_names_the_line_that_builds_one() {
    let output = Command::new(env!("CARGO_BIN_EXE_coilsense")).args(["app", "--no-open"]).output().expect("it starts");
    let message = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(output.stdout.is_empty());
    let line = "cargo xtask page && cargo build --release --package coilsense-cli --features app";
    assert!(message.contains(line), "{message}");
}

#[cfg(page_is_built)]
mod served {
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    use super::answering::answering;

    /// A command that serves, ended with the test.
    struct Served {
        child: Child,
        port: u16,
    }

    impl Drop for Served {
        fn drop(&mut self) {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }

    struct Reply {
        status: u16,
        head: String,
        body: Vec<u8>,
    }

    impl Served {
        fn begin(arguments: &[&str]) -> Self {
            let mut command = answering();
            command.args(["app", "--no-open"]).args(arguments).stdout(Stdio::piped());
            let mut child = command.spawn().expect("it starts");
            let mut line = String::new();
            BufReader::new(child.stdout.as_mut().expect("piped")).read_line(&mut line).expect("a line");
            let after = line.split_once("http://127.0.0.1:").unwrap_or_else(|| panic!("an address, got {line}")).1;
            let port = after.split_once('/').expect("a path").0.parse().expect("a port");
            Self { child, port }
        }

        /// The bytes as they are: a browser would tidy the path.
        fn ask(&self, method: &str, path: &str, host: &str) -> Reply {
            let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("it listens");
            stream.set_read_timeout(Some(Duration::from_secs(10))).expect("a timeout");
            write!(stream, "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").expect("sent");
            let mut all = Vec::new();
            stream.read_to_end(&mut all).expect("an answer");
            let end = all.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
            let head = String::from_utf8(all[..end].to_vec()).expect("UTF-8");
            let status = head.split(' ').nth(1).and_then(|word| word.parse().ok()).expect("a status");
            Reply { status, head, body: all[end + 4..].to_vec() }
        }

        fn get(&self, path: &str) -> Reply {
            self.ask("GET", path, &format!("127.0.0.1:{}", self.port))
        }
    }

    fn built(name: &str) -> Vec<u8> {
        std::fs::read(format!("{}/../../web/dist/{name}", env!("CARGO_MANIFEST_DIR"))).expect("a file of the page")
    }

    fn has(reply: &Reply, header: &str) -> bool {
        reply.head.lines().any(|line| line.eq_ignore_ascii_case(header))
    }

    #[test]
    fn every_file_of_the_page_is_served_as_what_it_is() {
        let served = Served::begin(&[]);
        let start = served.get("/");
        assert_eq!((start.status, &start.body), (200, &built("index.html")));
        assert!(has(&start, "content-type: text/html; charset=utf-8"), "{}", start.head);
        assert!(start.head.contains("default-src 'self'"), "{}", start.head);
        let folder = std::fs::read_dir(format!("{}/../../web/dist/assets", env!("CARGO_MANIFEST_DIR"))).expect("built");
        let mut kinds = 0;
        for file in folder {
            let name = format!("assets/{}", file.expect("a file").file_name().into_string().expect("UTF-8"));
            let reply = served.get(&format!("/{name}?anything"));
            assert!(reply.status == 200 && reply.body == built(&name), "{name}: {}", reply.head);
            assert!(has(&reply, &format!("content-length: {}", reply.body.len())), "{}", reply.head);
            assert!(has(&reply, "x-content-type-options: nosniff"), "{}", reply.head);
            let wanted = match name.rsplit('.').next() {
                Some("wasm") => "application/wasm",
                Some("js") => "text/javascript; charset=utf-8",
                Some("css") => "text/css; charset=utf-8",
                _ => continue,
            };
            assert!(has(&reply, &format!("content-type: {wanted}")), "{name}: {}", reply.head);
            kinds += 1;
        }
        assert!(kinds >= 3, "engine, scripts and style");
    }

    #[test]
    fn nothing_but_the_page_is_served() {
        let served = Served::begin(&[]);
        let tries = [
            "/../Cargo.toml",
            "/assets/../../Cargo.toml",
            "/%2e%2e/Cargo.toml",
            "//etc/passwd",
            "/..%2f..%2fetc/passwd",
        ];
        for path in tries.into_iter().chain(["/assets", "/assets/", "/nothing", "/..\\Cargo.toml"]) {
            let reply = served.get(path);
            assert_eq!((reply.status, reply.body.as_slice()), (404, b"no such file in the page".as_slice()), "{path}");
        }
    }

    #[test]
    fn only_this_machine_reads_and_nobody_writes() {
        let served = Served::begin(&[]);
        let own = format!("localhost:{}", served.port);
        assert_eq!(served.ask("GET", "/", &own).status, 200);
        // A name of another site that resolves to 127.0.0.1.
        for host in ["example.org", "127.0.0.1", "127.0.0.1:1", &format!("example.org:{}", served.port)] {
            assert_eq!(served.ask("GET", "/", host).status, 403, "{host}");
        }
        let head = served.ask("HEAD", "/", &own);
        assert!(head.status == 200 && head.body.is_empty());
        assert!(has(&head, &format!("content-length: {}", built("index.html").len())), "{}", head.head);
        let post = served.ask("POST", "/", &own);
        assert!(post.status == 405 && has(&post, "allow: GET, HEAD"), "{}", post.head);
    }

    #[test]
    fn a_port_that_is_taken_is_refused_in_one_line() {
        let served = Served::begin(&[]);
        let arguments = ["app", "--no-open", "--port", &served.port.to_string()];
        let second = Command::new(env!("CARGO_BIN_EXE_coilsense")).args(arguments).output().expect("it starts");
        let message = String::from_utf8(second.stderr).expect("UTF-8");
        assert_eq!((second.status.code(), message.lines().count()), (Some(2), 1), "{message}");
        assert!(message.contains(&format!("127.0.0.1:{}", served.port)), "{message}");
    }

    /// What a reader that is no browser gets; nothing where the connection is ended without a word.
    fn rest(mut stream: &TcpStream) -> String {
        let mut all = Vec::new();
        stream.set_read_timeout(Some(Duration::from_secs(20))).expect("a timeout");
        // What is ended in the middle of a request may come as an error.
        let _ = stream.read_to_end(&mut all);
        String::from_utf8_lossy(&all).into_owned()
    }

    #[test]
    fn thousands_who_ask_nothing_keep_nobody_waiting() {
        let served = Served::begin(&[]);
        let connect = || TcpStream::connect(("127.0.0.1", served.port));
        let mut idle = Vec::new();
        for _ in 0..2000 {
            match connect() {
                Ok(stream) => idle.push(stream),
                // This process may have no more.
                Err(_) => break,
            }
        }
        assert!(idle.len() > 500, "{}", idle.len());
        // One for the next reader of our own.
        idle.pop();
        let begun = Instant::now();
        assert_eq!(served.get("/").status, 200);
        assert!(begun.elapsed() < Duration::from_secs(2), "{:?}", begun.elapsed());
        // The newest wait on, the oldest are gone.
        assert_eq!(rest(&idle[0]), "");
        #[cfg(target_os = "linux")]
        {
            let threads = || {
                let status =
                    std::fs::read_to_string(format!("/proc/{}/status", served.child.id())).expect("its status");
                let threads = status.lines().find_map(|line| line.strip_prefix("Threads:")).expect("a line");
                threads.trim().parse::<u32>().expect("a number")
            };
            // Those whose connections are ended go as soon as a busy machine lets them.
            let begun = Instant::now();
            while threads() >= 100 && begun.elapsed() < Duration::from_secs(10) {
                std::thread::sleep(Duration::from_millis(20));
            }
            assert!(threads() < 100, "{}", threads());
        }
    }

    #[test]
    fn a_head_without_an_end_and_one_that_drips_are_ended() {
        let served = Served::begin(&[]);
        let connect = || TcpStream::connect(("127.0.0.1", served.port)).expect("it listens");
        let mut endless = connect();
        let _ = endless.write_all(b"GET / HTTP/1.1\r\n");
        let line = format!("X-Y: {}\r\n", "z".repeat(1000));
        let sent = (0..10_000).take_while(|_| endless.write_all(line.as_bytes()).is_ok()).count();
        assert!(sent < 9_000, "{sent} kB of headers were taken");
        for (bytes, status) in [
            (format!("GET / HTTP/1.1\r\n{}", "A: b\r\n".repeat(100)), "431"),
            (format!("GET /{} HTTP/1.1\r\n", "x".repeat(17_000)), "431"),
            ("no request at all\r\n\r\n".to_owned(), "400"),
        ] {
            let mut stream = connect();
            stream.write_all(bytes.as_bytes()).expect("sent");
            let said = rest(&stream);
            assert!(said.starts_with(&format!("HTTP/1.1 {status} ")), "{said}");
        }
        let mut slow = connect();
        let begun = Instant::now();
        while slow.write_all(b"G").is_ok() {
            assert!(begun.elapsed() < Duration::from_secs(20), "it waits on");
            std::thread::sleep(Duration::from_millis(200));
        }
        assert!(begun.elapsed() > Duration::from_secs(5), "{:?}", begun.elapsed());
        assert_eq!(served.get("/").status, 200);
    }

    #[test]
    fn a_connection_carries_several_requests() {
        let served = Served::begin(&[]);
        let mut stream = TcpStream::connect(("127.0.0.1", served.port)).expect("it listens");
        let host = format!("Host: 127.0.0.1:{}\r\n", served.port);
        write!(stream, "HEAD / HTTP/1.1\r\n{host}\r\nGET /nothing HTTP/1.1\r\n{host}Connection: close\r\n\r\n")
            .expect("sent");
        let said = rest(&stream);
        assert!(said.contains("HTTP/1.1 200 OK") && said.contains("HTTP/1.1 404 Not Found"), "{said}");
        // A body would be taken for a request; and who names two hosts names none.
        let mut stream = TcpStream::connect(("127.0.0.1", served.port)).expect("it listens");
        write!(stream, "GET / HTTP/1.1\r\n{host}Content-Length: 40\r\n\r\nGET /nothing HTTP/1.1\r\n{host}\r\n")
            .expect("sent");
        assert_eq!(rest(&stream).matches("HTTP/1.1 ").count(), 1);
        let mut stream = TcpStream::connect(("127.0.0.1", served.port)).expect("it listens");
        write!(stream, "GET / HTTP/1.1\r\n{host}Host: example.org\r\nConnection: close\r\n\r\n").expect("sent");
        assert!(rest(&stream).starts_with("HTTP/1.1 403 "));
    }

    #[cfg(unix)]
    #[test]
    fn ctrl_c_ends_it() {
        let mut served = Served::begin(&[]);
        assert_eq!(served.get("/").status, 200);
        assert!(Command::new("kill").args(["-INT", &served.child.id().to_string()]).status().expect("kill").success());
        let begun = Instant::now();
        loop {
            if let Some(status) = served.child.try_wait().expect("a child") {
                assert!(status.success(), "{status}");
                break;
            }
            assert!(begun.elapsed() < Duration::from_secs(10), "it goes on");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}
