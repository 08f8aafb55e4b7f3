/* Makes chosen system calls of a program fail, and records what it does to its files.
 *
 * Loaded by LD_PRELOAD. Only calls on paths that begin with FAULT_ROOT count.
 *   FAULT_CALL    the call that fails: open, read, pread, write, pwrite, fsync, fdatasync, rename, link, unlink, close,
 *                 mkdir, ftruncate or flock
 *   FAULT_NUMBER  which of them, from 1; with FAULT_FOREVER that one and all after it
 *   FAULT_ERRNO   the error; 0 for a read or write of half the bytes
 *   FAULT_COUNTS  a file that gets the number of calls of each kind at the end
 *   FAULT_TRACE   a file that gets each change: a line "call<TAB>path<TAB>other path<TAB>offset<TAB>bytes", then the bytes
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum call { OPEN, READ, PREAD, WRITE, PWRITE, FSYNC, FDATASYNC, RENAME, LINK, UNLINK, CLOSE, MKDIR, FTRUNCATE, FLOCK, CALLS };
static const char *const NAMES[CALLS] = {"open",   "read", "pread",  "write", "pwrite", "fsync",     "fdatasync",
                                         "rename", "link", "unlink", "close", "mkdir",  "ftruncate", "flock"};

static struct {
    char root[4096];
    enum call failing;
    long number, counts[CALLS];
    int forever, error, trace, ready;
} state = {.failing = CALLS, .trace = -1};
static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;

static void write_all(int fd, const char *bytes, size_t size) {
    while (size > 0) {
        long written = syscall(SYS_write, fd, bytes, size);
        if (written <= 0) abort();
        bytes += written;
        size -= (size_t)written;
    }
}

static void write_counts(void) {
    const char *path = getenv("FAULT_COUNTS");
    if (!path) return;
    int fd = (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    for (int call = 0; call < CALLS; call++) {
        char line[64];
        write_all(fd, line, (size_t)snprintf(line, sizeof line, "%s %ld\n", NAMES[call], state.counts[call]));
    }
    syscall(SYS_close, fd);
}

static void prepare(void) {
    if (state.ready) return;
    state.ready = 1;
    const char *value;
    if ((value = getenv("FAULT_ROOT"))) snprintf(state.root, sizeof state.root, "%s", value);
    if ((value = getenv("FAULT_CALL")))
        for (int call = 0; call < CALLS; call++)
            if (!strcmp(value, NAMES[call])) state.failing = call;
    state.number = (value = getenv("FAULT_NUMBER")) ? atol(value) : 0;
    state.error = (value = getenv("FAULT_ERRNO")) ? atoi(value) : EIO;
    state.forever = getenv("FAULT_FOREVER") != NULL;
    if ((value = getenv("FAULT_TRACE")))
        state.trace = (int)syscall(SYS_openat, AT_FDCWD, value, O_WRONLY | O_CREAT | O_APPEND, 0644);
    atexit(write_counts);
}

static int counts_here(const char *path) { return state.root[0] && !strncmp(path, state.root, strlen(state.root)); }

/* The absolute form of a path; true if it counts. */
static int path_of(const char *path, char *absolute) {
    prepare();
    char here[2048] = "";
    if (path[0] != '/' && syscall(SYS_getcwd, here, sizeof here) < 0) return 0;
    snprintf(absolute, 4096, "%s%s%s", here, path[0] == '/' ? "" : "/", path);
    return counts_here(absolute);
}

/* The path of an open file; true if it counts. */
static int path_of_file(int fd, char *absolute) {
    prepare();
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    long length = syscall(SYS_readlink, link, absolute, 4095);
    if (fd <= 2 || length < 0) return 0;
    absolute[length] = 0;
    return counts_here(absolute);
}

/* Counts a call; true if it is to fail. */
static int fails(enum call call) {
    pthread_mutex_lock(&guard);
    long number = ++state.counts[call];
    pthread_mutex_unlock(&guard);
    return call == state.failing && (state.forever ? number >= state.number : number == state.number);
}

static void record(const char *call, const char *path, const char *other, long offset, const void *bytes, long size) {
    if (state.trace < 0) return;
    char line[9000];
    int length = snprintf(line, sizeof line, "%s\t%s\t%s\t%ld\t%ld\n", call, path, other, offset, size);
    pthread_mutex_lock(&guard);
    write_all(state.trace, line, (size_t)length);
    if (size > 0) write_all(state.trace, bytes, (size_t)size);
    pthread_mutex_unlock(&guard);
}

#define FAIL_OR_HALF(call, size)           \
    if (fails(call)) {                     \
        if (state.error) {                 \
            errno = state.error;           \
            return -1;                     \
        }                                  \
        if (size > 1) size /= 2;           \
    }
#define FAIL(call)           \
    if (fails(call)) {       \
        errno = state.error; \
        return -1;           \
    }

static int opened(int directory, const char *path, int flags, unsigned mode) {
    char absolute[4096];
    int counts = path_of(path, absolute);
    if (counts) FAIL(OPEN);
    int is_new = (flags & O_CREAT) && syscall(SYS_faccessat, AT_FDCWD, absolute, F_OK) != 0;
    int fd = (int)syscall(SYS_openat, directory, path, flags, mode);
    if (counts && fd >= 0 && is_new) record("create", absolute, "", 0, NULL, 0);
    if (counts && fd >= 0 && !is_new && (flags & O_TRUNC)) record("ftruncate", absolute, "", 0, NULL, 0);
    return fd;
}

#define MODE(flags)                    \
    va_list list;                      \
    va_start(list, flags);             \
    unsigned mode = va_arg(list, unsigned); \
    va_end(list)

int open(const char *path, int flags, ...) { MODE(flags); return opened(AT_FDCWD, path, flags, mode); }
int open64(const char *path, int flags, ...) { MODE(flags); return opened(AT_FDCWD, path, flags, mode); }
int openat(int at, const char *path, int flags, ...) { MODE(flags); return opened(at, path, flags, mode); }
int openat64(int at, const char *path, int flags, ...) { MODE(flags); return opened(at, path, flags, mode); }

ssize_t read(int fd, void *bytes, size_t size) {
    char path[4096];
    if (path_of_file(fd, path)) { FAIL_OR_HALF(READ, size) }
    return syscall(SYS_read, fd, bytes, size);
}

ssize_t pread64(int fd, void *bytes, size_t size, off64_t offset) {
    char path[4096];
    if (path_of_file(fd, path)) { FAIL_OR_HALF(PREAD, size) }
    return syscall(SYS_pread64, fd, bytes, size, offset);
}
ssize_t pread(int fd, void *bytes, size_t size, off_t offset) { return pread64(fd, bytes, size, offset); }

ssize_t write(int fd, const void *bytes, size_t size) {
    char path[4096];
    int counts = path_of_file(fd, path);
    if (counts) { FAIL_OR_HALF(WRITE, size) }
    long end = -1;
    if (counts) {
        struct stat64 status;
        int appends = (int)syscall(SYS_fcntl, fd, F_GETFL) & O_APPEND;
        end = appends && !fstat64(fd, &status) ? (long)status.st_size : syscall(SYS_lseek, fd, 0, SEEK_CUR);
    }
    long written = syscall(SYS_write, fd, bytes, size);
    if (counts && written > 0) record("write", path, "", end, bytes, written);
    return written;
}

ssize_t writev(int fd, const struct iovec *parts, int count) {
    char path[4096];
    if (!path_of_file(fd, path)) return syscall(SYS_writev, fd, parts, count);
    ssize_t total = 0;
    for (int part = 0; part < count; part++) {
        if (!parts[part].iov_len) continue;
        ssize_t written = write(fd, parts[part].iov_base, parts[part].iov_len);
        if (written < 0) return total ? total : -1;
        total += written;
        if ((size_t)written < parts[part].iov_len) break;
    }
    return total;
}

ssize_t pwrite64(int fd, const void *bytes, size_t size, off64_t offset) {
    char path[4096];
    int counts = path_of_file(fd, path);
    if (counts) { FAIL_OR_HALF(PWRITE, size) }
    long written = syscall(SYS_pwrite64, fd, bytes, size, offset);
    if (counts && written > 0) record("write", path, "", offset, bytes, written);
    return written;
}
ssize_t pwrite(int fd, const void *bytes, size_t size, off_t offset) { return pwrite64(fd, bytes, size, offset); }

/* Nothing is brought to the disk: the tests look at what was asked for, and need not wait. */
static int synchronised(int fd, enum call call) {
    char path[4096];
    if (!path_of_file(fd, path)) return (int)syscall(call == FSYNC ? SYS_fsync : SYS_fdatasync, fd);
    FAIL(call);
    record("fsync", path, "", 0, NULL, 0);
    return 0;
}
int fsync(int fd) { return synchronised(fd, FSYNC); }
int fdatasync(int fd) { return synchronised(fd, FDATASYNC); }

int ftruncate64(int fd, off64_t length) {
    char path[4096];
    int counts = path_of_file(fd, path);
    if (counts) FAIL(FTRUNCATE);
    int answer = (int)syscall(SYS_ftruncate, fd, length);
    if (counts && !answer) record("ftruncate", path, "", length, NULL, 0);
    return answer;
}
int ftruncate(int fd, off_t length) { return ftruncate64(fd, length); }

int flock(int fd, int operation) {
    char path[4096];
    if (path_of_file(fd, path)) FAIL(FLOCK);
    return (int)syscall(SYS_flock, fd, operation);
}

int close(int fd) {
    char path[4096];
    if (path_of_file(fd, path) && fails(CLOSE)) {
        syscall(SYS_close, fd);
        errno = state.error;
        return -1;
    }
    return (int)syscall(SYS_close, fd);
}

int rename(const char *from, const char *to) {
    char source[4096], target[4096];
    int counts = path_of(from, source) | path_of(to, target);
    if (counts) FAIL(RENAME);
    int answer = (int)syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to);
    if (counts && !answer) record("rename", source, target, 0, NULL, 0);
    return answer;
}

int linkat(int from_at, const char *from, int to_at, const char *to, int flags) {
    char source[4096], target[4096];
    int counts = path_of(from, source) | path_of(to, target);
    if (counts) FAIL(LINK);
    int answer = (int)syscall(SYS_linkat, from_at, from, to_at, to, flags);
    if (counts && !answer) record("link", source, target, 0, NULL, 0);
    return answer;
}

int unlink(const char *path) {
    char absolute[4096];
    int counts = path_of(path, absolute);
    if (counts) FAIL(UNLINK);
    int answer = (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
    if (counts && !answer) record("unlink", absolute, "", 0, NULL, 0);
    return answer;
}

int mkdir(const char *path, mode_t mode) {
    char absolute[4096];
    int counts = path_of(path, absolute);
    if (counts) FAIL(MKDIR);
    int answer = (int)syscall(SYS_mkdirat, AT_FDCWD, path, mode);
    if (counts && !answer) record("mkdir", absolute, "", 0, NULL, 0);
    return answer;
}
