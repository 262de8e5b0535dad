#!/usr/bin/env python3
"""`view` and `studio` under attack: answered or refused, never down, memory bounded."""
import http.client
import json
import os
import resource
import signal
import socket
import subprocess
import threading
import time
import urllib.parse

from campaign import Campaign, Failure, fresh

campaign = Campaign(__doc__, [(["--connections"], {"type": int, "default": 300, "help": "open at once"}),
                              (["--slow"], {"type": int, "default": 100, "help": "clients that send a byte at a time"})])
MOST_GROWTH_MIB = 150
PATIENT_S = 15  # an honest client is answered within, while others do their worst


class Server:
    def __init__(self, args):
        self.process = subprocess.Popen([campaign.program, *args, "--port", "0", "--json"], cwd=campaign.work,
                                        env=campaign.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL)
        text = b""
        while not text.rstrip().endswith(b"}"):
            line = self.process.stdout.readline()
            if not line:
                raise Failure(f"{args[0]} ended with {self.process.wait()}")
            text += line
        self.port = urllib.parse.urlparse(json.loads(text)["address"]).port

    def resident_mib(self):
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as status:
            return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS"))

    def get(self, path, headers=None, method="GET", body=None, timeout=PATIENT_S):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.putrequest(method, path, skip_host="Host" in (headers or {}))
            for name, value in (headers or {}).items():
                connection.putheader(name, value)
            if body is not None:
                connection.putheader("Content-Length", str(len(body)))
            connection.endheaders(body)
            answer = connection.getresponse()
            answer.body = answer.read()
            return answer
        finally:
            connection.close()

    def raw(self, data, wait=2.0):
        """Sends bytes as they are; what came back, at most 64 KiB."""
        out = b""
        with socket.create_connection(("127.0.0.1", self.port), timeout=wait) as s:
            try:
                s.sendall(data)
                while len(out) < 65536 and (more := s.recv(65536)):
                    out += more
            except OSError:
                pass  # refused by closing, or nothing more to come
            return out

    def is_well(self, path="/"):
        if self.process.poll() is not None:
            raise Failure(f"the server is down: {self.process.returncode}")
        begin = time.monotonic()
        try:
            status = self.get(path).status
        except OSError as error:
            raise Failure(f"an honest client got {error!r} after {time.monotonic() - begin:.1f} s") from None
        if status not in (200, 302):
            raise Failure(f"an honest client got {status}")
        return time.monotonic() - begin


def expect(condition, text):
    if not condition:
        raise Failure(text)


def headers(server, path):
    answer = server.get(path)
    expect(answer.status in (200, 302), f"{path}: {answer.status}")
    policy = answer.getheader("Content-Security-Policy") or ""
    expect("default-src 'none'" in policy and "frame-ancestors" in policy, f"{path}: policy \"{policy}\"")
    expect("http" not in policy, f"{path}: the policy allows the outside: {policy}")
    for name, value in [("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer"),
                        ("Cross-Origin-Resource-Policy", "same-origin")]:
        expect(answer.getheader(name) == value, f"{path}: {name} is {answer.getheader(name)}")


def strangers(server, path):
    own = f"127.0.0.1:{server.port}"
    for bad in [{"Host": "evil.example"}, {"Host": f"evil.example:{server.port}"}, {"Host": "127.0.0.1.evil.example"},
                {"Host": f"127.0.0.1:{server.port}@evil.example"}, {"Host": own, "Origin": "http://evil.example"},
                {"Host": own, "Origin": "null"}, {"Host": own, "Origin": f"https://{own}"},
                {"Host": own, "Origin": f"http://{own}.evil.example"}]:
        expect(server.get(path, bad).status == 403, f"answered to {bad}")
    twice = f"GET {path} HTTP/1.1\r\nHost: {own}\r\nHost: evil.example\r\n\r\n".encode()
    expect(b" 403 " in server.raw(twice).split(b"\r\n")[0], "two Host headers were answered")
    expect(b" 403 " in server.raw(f"GET {path} HTTP/1.0\r\n\r\n".encode()).split(b"\r\n")[0], "no Host was answered")


def ways_out(server, secret, prefixes):
    ups = ["../" * n for n in range(1, 9)] + ["..%2f" * 6, "%2e%2e/" * 6, "%2e%2e%2f" * 6, "..%5c" * 6, "....//" * 6,
                                              "%252e%252e%252f" * 6, "..;/" * 6, "%c0%ae%c0%ae/" * 6, "./" * 3, "/" * 4]
    targets = ["etc/passwd", str(secret).lstrip("/"), "link", "folder-link/secret.txt", ".hidden", "run.json%00.html"]
    for prefix in prefixes:
        for up in ups:
            for target in targets:
                answer = server.raw(f"GET {prefix}{up}{target} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                                    "Connection: close\r\n\r\n".encode(), 5)
                expect(b"root:" not in answer and b"the secret" not in answer, f"a way out: {prefix}{up}{target}")


def nonsense(server):
    host = f"Host: 127.0.0.1:{server.port}\r\n".encode()
    for data in [b"\0" * 4096, b"GET", b"\r\n" * 10000, b"GET / HTTP/9.9\r\n\r\n", os.urandom(65536),
                 b"GET /" + b"a" * 100000 + b" HTTP/1.1\r\n" + host + b"\r\n",
                 b"GET / HTTP/1.1\r\n" + host + b"X: " + b"a" * 1000000 + b"\r\n\r\n",
                 b"GET / HTTP/1.1\r\n" + host + b"".join(b"X%d: a\r\n" % i for i in range(20000)) + b"\r\n",
                 b"POST / HTTP/1.1\r\n" + host + b"Content-Length: 99999999999999999999\r\n\r\nabc",
                 b"POST / HTTP/1.1\r\n" + host + b"Content-Length: -1\r\n\r\nabc",
                 b"POST / HTTP/1.1\r\n" + host + b"Transfer-Encoding: chunked\r\n\r\nFFFFFFFFFFFFFFFF\r\nabc",
                 b"POST / HTTP/1.1\r\n" + host + b"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\nGET",
                 b"PUT / HTTP/1.1\r\n" + host + b"\r\n", b"DELETE /run.json HTTP/1.1\r\n" + host + b"\r\n",
                 b"OPTIONS * HTTP/1.1\r\n" + host + b"\r\n", b"TRACE / HTTP/1.1\r\n" + host + b"\r\n",
                 b"CONNECT evil.example:80 HTTP/1.1\r\n" + host + b"\r\n"]:
        server.raw(data)
    server.is_well()


def ranges(server, path):
    size = len(server.get(path).body)
    before = server.resident_mib()
    many = {"Range": "bytes=" + ",".join(["0-"] * 1000)}
    expect(server.get(path, many).status in (400, 416), "a thousand ranges were answered")
    for text in ["bytes=5-2", "bytes=-0", f"bytes={size}-", "bytes=0-99999999999999999999", "bytes=a-b", "bytes=-",
                 "bytes=0-0,-1", "lines=1-2", "bytes=" + "9" * 5000 + "-"]:
        try:
            server.get(path, {"Range": text})
        except (http.client.HTTPException, OSError):
            pass  # refused by closing
    part = server.get(path, {"Range": "bytes=1-3"})
    expect(part.status == 206 and len(part.body) == 3, f"bytes 1-3: {part.status}, {len(part.body)} bytes")
    expect(server.resident_mib() - before < MOST_GROWTH_MIB, "ranges take memory")


def slow_clients(server, count):
    """Each sends a byte now and then, and never a whole request."""
    end = threading.Event()

    def drip():
        try:
            with socket.create_connection(("127.0.0.1", server.port), timeout=10) as s:
                for byte in b"GET / HTTP/1.1\r\nX-Slow: " + b"a" * 10000:
                    s.send(bytes([byte]))
                    if end.wait(0.5):
                        return
        except OSError:
            pass

    threads = [threading.Thread(target=drip) for _ in range(count)]
    for thread in threads:
        thread.start()
    time.sleep(1)
    try:
        return max(server.is_well() for _ in range(3))
    finally:
        end.set()
        for thread in threads:
            thread.join()


def many_connections(server, count):
    """Opened, and nothing sent."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, max(soft, count + 200)), hard))
    before, sockets = server.resident_mib(), []
    try:
        for _ in range(count):
            s = socket.socket()
            s.setblocking(False)
            s.connect_ex(("127.0.0.1", server.port))
            sockets.append(s)
        server.is_well()
    finally:
        for s in sockets:
            s.close()
    server.is_well()
    growth = server.resident_mib() - before
    expect(growth < MOST_GROWTH_MIB, f"{count} connections took {growth:.0f} MiB")


def attack(name, server, file, prefixes, secret):
    for what, act in [("headers", lambda: [headers(server, p) for p in ("/", file)]),
                      ("strangers", lambda: strangers(server, file)),
                      ("ways out", lambda: ways_out(server, secret, prefixes)), ("nonsense", lambda: nonsense(server)),
                      ("ranges", lambda: ranges(server, file)),
                      ("slow clients", lambda: slow_clients(server, campaign.args.slow)),
                      ("many connections", lambda: many_connections(server, campaign.args.connections))]:
        campaign.attempt(f"{name}: {what}", act)
    server.process.send_signal(signal.SIGTERM)
    campaign.attempt(f"{name}: end", lambda: server.process.wait(3))


campaign.need("run")
home = fresh(campaign.work / "served")
secret_file = campaign.work / "secret.txt"
secret_file.write_text("the secret\n")
subprocess.run(["cp", "-r", campaign.inputs / "run", home / "bedroom"], check=True)
scene = home / "bedroom"
(scene / "link").symlink_to(secret_file)
(scene / "folder-link").symlink_to(campaign.work)
(scene / ".hidden").write_text("the secret\n")
if not campaign.args.only or "view" in campaign.args.only:
    attack("view", Server(["view", str(scene)]), "/preview.jpg", ["/", "/viewer/", "/splat/"], secret_file)
if not campaign.args.only or "studio" in campaign.args.only:
    attack("studio", Server(["studio", str(home), "--no-open"]), "/files/bedroom/preview.jpg",
           ["/", "/assets/", "/files/", "/files/bedroom/", "/files/bedroom/splat/"], secret_file)
campaign.end("attacks withstood")
