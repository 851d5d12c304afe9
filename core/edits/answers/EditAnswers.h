// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

namespace core {

// What every kind of edit X answers, in X.cpp beside X.h. Each has these functions, by exactly
// these signatures; EditTask.h, EditRows.h and DocumentEdits.h ask them of any edit.
//
//   Result<void> check(const X&, const Document&)
//     Whether it may be done, asked at the door and again where it waited in line: what it changes
//     in the document, what it names, and that an engine's command can be made of it.
//   Result<bool> apply(const X&, Document&)
//     What it changes in the document, lists and what they say; whether anything is different then.
//     Errors: UnknownSegment, SegmentLocked, InvalidField; nothing is changed then.
//   EditEffects effects(const X&)
//     Who carries it out, and what follows from that it was (EditEffects.h).
//   QString rowName(const X&, const RowFacts&)
//     Its row's name for people; part of the hash chain, so an old one must come out as it was.
//   EditReach reach(const X&, const ReachFacts&)
//     What its result depends on: rather too much than too little (EditReach.h).
//   Result<EngineEdit> engineEdit(const X&, const Document&)
//     Of those that the engine carries out: the command in whole numbers by which it is begun.
//     Their effects name engineTask<X>(), which does not compile without.
//
// Here is only what headers of edits need to declare them.

struct Document;
struct EditEffects;
struct EditReach;
struct EngineEdit;
struct ReachFacts;
struct RowFacts;

} // namespace core
