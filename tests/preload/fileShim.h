// SPDX-License-Identifier: Apache-2.0
//
// Preloaded into a program (LD_PRELOAD), for tests: tells what it does to the file system, and
// makes some of it fail. tests/support/faults/FileShim.h says what it is told and what it tells.
//
//   BURIN_SHIM_LOG    a file that lines are appended to: WHAT, PATH and more, with tabs between
//   BURIN_SHIM_UNDER  a folder: only what lies in it counts for the failing
//   BURIN_SHIM_FAIL   which calls fail, of "open", "write", "sync" and "rename", with commas
//   BURIN_SHIM_OF     only in processes with this first argument; unset: in all
//   BURIN_SHIM_NTH    the first of them that does, from 1; 0: none, they are only told ("counts")
//   BURIN_SHIM_LAST   the last of them that does
//   BURIN_SHIM_ERROR  a number (errno), or "short": half of what is to be written is
#pragma once

#include <limits.h>
#include <sys/types.h>

enum { pathBytes = 2 * PATH_MAX };

// Nobody but the shim sees these: what a preloaded library exports takes the place of others'.
#pragma GCC visibility push(hidden)

extern int shim_error; ///< errno of the calls that fail; 0: they write a part

/// A line in the log.
void shim_tell(const char* what, const char* path, const char* more);
/// The path from the root, as far as names alone can tell it; @p full holds pathBytes.
void shim_fullPath(int folder, const char* path, char* full);
/// Of a descriptor.
void shim_pathOf(int file, char* full);
/// In the folder in which calls fail.
int shim_isUnder(const char* full);
/// Whether calls of that kind are to fail at all.
int shim_isFailing(const char* kind);
/// Whether this one is to fail, now.
int shim_isTurn(const char* kind, const char* full);
/// How much of @p size is to be written; -1: nothing, errno says why.
ssize_t shim_granted(int file, size_t size);

#pragma GCC visibility pop
