/* Preloaded into the program: lets writing to some files go wrong, as disks and file systems do.
 *
 * HAWSER_FAULT   eio: the call fails; short: it writes a part only, and says so; lost: it says that all is written, and
 *                nothing is; full: no space is left, from here on; readonly: nothing can be opened for writing, named or
 *                removed, from here on
 * HAWSER_FAULT_IN     a part of the paths of the files that it is about
 * HAWSER_FAULT_AFTER  calls that go well before
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long calls = 0;

static int is_kind(const char* kind) {
  const char* wanted = getenv("HAWSER_FAULT");
  return wanted != NULL && strcmp(wanted, kind) == 0;
}

static int concerns(const char* path) {
  const char* part = getenv("HAWSER_FAULT_IN");
  return part != NULL && path != NULL && strstr(path, part) != NULL;
}

static int concerns_open(int fd) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  if (size <= 0) return 0;
  path[size] = 0;
  return concerns(path);
}

/* Whether this call is one to go wrong; a single one, or all from there on. */
static int is_due(int for_good) {
  const char* after = getenv("HAWSER_FAULT_AFTER");
  const long number = ++calls, from = after == NULL ? 0 : atol(after);
  return for_good ? number > from : number == from + 1;
}

enum verdict { pass, fail, shorten, lose };

static enum verdict judge(int fd) {
  const int keep = errno;
  enum verdict verdict = pass;
  if (concerns_open(fd)) {
    if (is_kind("eio") && is_due(0)) errno = EIO, verdict = fail;
    else if (is_kind("full") && is_due(1)) errno = ENOSPC, verdict = fail;
    else if (is_kind("short") && is_due(1)) verdict = shorten;
    else if (is_kind("lost") && is_due(0)) verdict = lose;
  }
  if (verdict != fail) errno = keep;
  return verdict;
}

/* The function of that name that this file stands in for. */
#define REAL(name)                                  \
  static __typeof__(name)* real = NULL;             \
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, #name)

ssize_t write(int fd, const void* data, size_t count) {
  REAL(write);
  switch (judge(fd)) {
    case fail: return -1;
    case lose: return (ssize_t)count;
    case shorten: return real(fd, data, count > 1 ? count / 2 : count);
    default: return real(fd, data, count);
  }
}

ssize_t pwrite(int fd, const void* data, size_t count, off_t at) {
  REAL(pwrite);
  switch (judge(fd)) {
    case fail: return -1;
    case lose: return (ssize_t)count;
    case shorten: return real(fd, data, count > 1 ? count / 2 : count, at);
    default: return real(fd, data, count, at);
  }
}
ssize_t pwrite64(int fd, const void* data, size_t count, off_t at) { return pwrite(fd, data, count, at); }

static ssize_t total(const struct iovec* parts, int count) {
  ssize_t sum = 0;
  for (int i = 0; i < count; ++i) sum += (ssize_t)parts[i].iov_len;
  return sum;
}

ssize_t writev(int fd, const struct iovec* parts, int count) {
  REAL(writev);
  switch (judge(fd)) {
    case fail: return -1;
    case lose: return total(parts, count);
    case shorten: return real(fd, parts, 1);
    default: return real(fd, parts, count);
  }
}

ssize_t pwritev(int fd, const struct iovec* parts, int count, off_t at) {
  REAL(pwritev);
  switch (judge(fd)) {
    case fail: return -1;
    case lose: return total(parts, count);
    case shorten: return real(fd, parts, 1, at);
    default: return real(fd, parts, count, at);
  }
}
ssize_t pwritev64(int fd, const struct iovec* parts, int count, off_t at) { return pwritev(fd, parts, count, at); }

int fsync(int fd) {
  REAL(fsync);
  return judge(fd) == fail ? -1 : real(fd);
}

int fallocate(int fd, int mode, off_t at, off_t size) {
  REAL(fallocate);
  return judge(fd) == fail ? -1 : real(fd, mode, at, size);
}
int fallocate64(int fd, int mode, off_t at, off_t size) { return fallocate(fd, mode, at, size); }

static int is_barred(const char* path) {
  if (!is_kind("readonly") || !concerns(path) || !is_due(1)) return 0;
  errno = EROFS;
  return 1;
}

int open(const char* path, int flags, ...) {
  REAL(open);
  va_list rest;
  va_start(rest, flags);
  const int mode = (flags & O_CREAT) != 0 ? va_arg(rest, int) : 0;
  va_end(rest);
  if ((flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0 && is_barred(path)) return -1;
  return real(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = (flags & O_CREAT) != 0 ? va_arg(rest, int) : 0;
  va_end(rest);
  return open(path, flags, mode);
}

FILE* fopen(const char* path, const char* how) {
  REAL(fopen);
  return strpbrk(how, "wa+") != NULL && is_barred(path) ? NULL : real(path, how);
}
FILE* fopen64(const char* path, const char* how) { return fopen(path, how); }

int rename(const char* from, const char* to) {
  REAL(rename);
  return is_barred(to) ? -1 : real(from, to);
}

int link(const char* from, const char* to) {
  REAL(link);
  return is_barred(to) ? -1 : real(from, to);
}
