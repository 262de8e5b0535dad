// LD_PRELOAD shim: lets calls that write files under a folder fail, as a full or broken disk does.
//
//   FAIL_UNDER    only what lies under this folder (absolute) is counted
//   FAIL_COUNTER  a file of 8 bytes, shared by all processes: the calls so far
//   FAIL_AT       which of them fails, from 1; 0: none, they are only counted
//   FAIL_LENGTH   how many in a row fail; 0: all that follow, as on a disk that stays full
//   FAIL_ERRNO    the error: 28 ENOSPC, 5 EIO, 30 EROFS, 122 EDQUOT
//   FAIL_LOG      a file that gets a line for each call
//
// Counted are open for writing, write, writev, pwrite, rename, mkdir, ftruncate, fsync, fdatasync, close of what was
// written, sendfile and copy_file_range. What the C library does within itself (fwrite) passes by unseen.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#define FDS 65536

static _Atomic unsigned char written[FDS];  // descriptors open for writing under FAIL_UNDER
static char under[PATH_MAX];
static atomic_long* counter;
static long fail_at, fail_length;
static int fail_errno, log_fd = -1;

static void* real(const char* name) { return dlsym(RTLD_NEXT, name); }
#define REAL(name)                     \
    static __typeof__(name)* p_##name; \
    if (!p_##name) p_##name = (__typeof__(name)*)real(#name)

static long number(const char* name) {
    const char* text = getenv(name);
    return text ? atol(text) : 0;
}

__attribute__((constructor)) static void begin(void) {
    const char* folder = getenv("FAIL_UNDER");
    const char* shared = getenv("FAIL_COUNTER");
    if (!folder || !shared) return;
    int (*open_)(const char*, int, ...) = (int (*)(const char*, int, ...))real("open");
    const int fd = open_(shared, O_RDWR | O_CLOEXEC);
    if (fd < 0) return;
    void* page = mmap(NULL, 8, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (page == MAP_FAILED) return;
    counter = page;
    fail_at = number("FAIL_AT"), fail_length = number("FAIL_LENGTH"), fail_errno = (int)number("FAIL_ERRNO");
    if (getenv("FAIL_LOG")) log_fd = open_(getenv("FAIL_LOG"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    snprintf(under, sizeof under, "%s/", folder);
}

// One call; 1 if it shall fail.
static int fails(const char* call, const char* path) {
    const long now = atomic_fetch_add(counter, 1) + 1;
    const int bad = fail_at > 0 && now >= fail_at && (fail_length == 0 || now < fail_at + fail_length);
    if (log_fd >= 0) {
        ssize_t (*write_)(int, const void*, size_t) = (ssize_t(*)(int, const void*, size_t))real("write");
        char line[PATH_MAX + 64];
        const int n = snprintf(line, sizeof line, "%ld %s %s%s\n", now, call, path, bad ? " FAILS" : "");
        if (n > 0 && write_(log_fd, line, (size_t)n) < 0) return bad;
    }
    if (bad) errno = fail_errno;
    return bad;
}

static int is_under(const char* path) {
    if (!counter || !path) return 0;
    char whole[2 * PATH_MAX], folder[PATH_MAX];
    if (path[0] == '/') {
        snprintf(whole, sizeof whole, "%s/", path);
    } else {
        if (!getcwd(folder, sizeof folder)) return 0;
        snprintf(whole, sizeof whole, "%s/%s/", folder, path);
    }
    return strncmp(whole, under, strlen(under)) == 0;
}

static void mark(int fd) {
    if (fd >= 0 && fd < FDS) written[fd] = 1;
}
static int is_marked(int fd) { return counter && fd >= 0 && fd < FDS && written[fd]; }
static int fails_on(const char* call, int fd) {
    if (!is_marked(fd)) return 0;
    char link[64], path[PATH_MAX] = "?";
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t n = log_fd >= 0 ? readlink(link, path, sizeof path - 1) : -1;
    if (n > 0) path[n] = 0;
    return fails(call, path);
}

static int opens(const char* name, const char* path, int flags, mode_t mode) {
    const int writes = (flags & O_ACCMODE) != O_RDONLY && is_under(path);
    if (writes && fails("open", path)) return -1;
    int (*open_)(const char*, int, ...) = (int (*)(const char*, int, ...))real(name);
    const int fd = open_(path, flags, mode);
    if (writes) mark(fd);
    return fd;
}

#define OPEN(name)                                              \
    int name(const char* path, int flags, ...) {                \
        va_list more;                                           \
        va_start(more, flags);                                  \
        const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(more, mode_t) : 0; \
        va_end(more);                                           \
        return opens(#name, path, flags, mode);                 \
    }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                            \
    int name(int at, const char* path, int flags, ...) {        \
        va_list more;                                           \
        va_start(more, flags);                                  \
        const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(more, mode_t) : 0; \
        va_end(more);                                           \
        const int writes = (flags & O_ACCMODE) != O_RDONLY && is_under(path);           \
        if (writes && fails("open", path)) return -1;           \
        int (*open_)(int, const char*, int, ...) = (int (*)(int, const char*, int, ...))real(#name); \
        const int fd = open_(at, path, flags, mode);            \
        if (writes) mark(fd);                                   \
        return fd;                                              \
    }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(name)                                             \
    FILE* name(const char* path, const char* mode) {            \
        const int writes = strpbrk(mode, "wa+") && is_under(path);                      \
        if (writes && fails("open", path)) return NULL;         \
        FILE* (*fopen_)(const char*, const char*) = (FILE * (*)(const char*, const char*)) real(#name); \
        FILE* file = fopen_(path, mode);                        \
        if (writes && file) mark(fileno(file));                 \
        return file;                                            \
    }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t write(int fd, const void* data, size_t size) {
    REAL(write);
    // A full disk takes what still fits: half of the bytes, and fails at the next call.
    if (is_marked(fd) && size > 1 && fail_errno == ENOSPC && fail_length == 0 && atomic_load(counter) + 1 == fail_at) {
        atomic_fetch_add(counter, 1);
        return p_write(fd, data, size / 2);
    }
    return fails_on("write", fd) ? -1 : p_write(fd, data, size);
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
    REAL(writev);
    return fails_on("writev", fd) ? -1 : p_writev(fd, parts, count);
}
#define PWRITE(name)                                            \
    ssize_t name(int fd, const void* data, size_t size, off_t at) {                     \
        ssize_t (*pwrite_)(int, const void*, size_t, off_t) = (ssize_t(*)(int, const void*, size_t, off_t))real(#name); \
        return fails_on("pwrite", fd) ? -1 : pwrite_(fd, data, size, at);               \
    }
PWRITE(pwrite)
PWRITE(pwrite64)

#define TRUNCATE(name)                                          \
    int name(int fd, off_t size) {                              \
        int (*truncate_)(int, off_t) = (int (*)(int, off_t))real(#name);                \
        return fails_on("ftruncate", fd) ? -1 : truncate_(fd, size);                    \
    }
TRUNCATE(ftruncate)
TRUNCATE(ftruncate64)

int fsync(int fd) {
    REAL(fsync);
    return fails_on("fsync", fd) ? -1 : p_fsync(fd);
}
int fdatasync(int fd) {
    REAL(fdatasync);
    return fails_on("fdatasync", fd) ? -1 : p_fdatasync(fd);
}
int close(int fd) {
    REAL(close);
    const int bad = fails_on("close", fd);
    if (fd >= 0 && fd < FDS) written[fd] = 0;
    const int code = p_close(fd);
    if (bad) errno = fail_errno;
    return bad ? -1 : code;
}
#define RENAME(name, parameters, arguments)                     \
    int name parameters {                                       \
        int(*rename_) parameters = (int(*) parameters)real(#name);                      \
        if ((is_under(from) || is_under(to)) && fails("rename", to)) return -1;         \
        return rename_ arguments;                               \
    }
RENAME(rename, (const char* from, const char* to), (from, to))
RENAME(renameat, (int a, const char* from, int b, const char* to), (a, from, b, to))
RENAME(renameat2, (int a, const char* from, int b, const char* to, unsigned flags), (a, from, b, to, flags))

int mkdir(const char* path, mode_t mode) {
    REAL(mkdir);
    struct stat there;
    if (is_under(path) && stat(path, &there) != 0 && fails("mkdir", path)) return -1;
    return p_mkdir(path, mode);
}
ssize_t sendfile(int to, int from, off_t* at, size_t size) {
    REAL(sendfile);
    return fails_on("sendfile", to) ? -1 : p_sendfile(to, from, at, size);
}
ssize_t copy_file_range(int from, off64_t* a, int to, off64_t* b, size_t size, unsigned flags) {
    REAL(copy_file_range);
    return fails_on("copy_file_range", to) ? -1 : p_copy_file_range(from, a, to, b, size, flags);
}
