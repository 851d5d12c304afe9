// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <memory>

namespace core {

// The functions that every kind of edit X must provide, in X.cpp beside X.h, with exactly these
// signatures. EditTask.h, EditRows.h and DocumentEdits.h call them for any edit.
//
//   Result<void> check(const X&, const Document&)
//     Whether it may be carried out: is the change of the document possible, does everything that
//     it refers to exist, and can an engine's command be made of it? Called when the edit is
//     requested and again after it has waited.
//   Result<bool> apply(const X&, Document&)
//     Changes the document's lists and their entries; returns whether anything differs now.
//     Errors: UnknownSegment, SegmentLocked, InvalidField; then nothing was changed.
//   EditEffects effects(const X&)
//     Who carries it out, and what else follows (EditEffects.h).
//   RowTitle rowTitle(const X&, const RowFacts&)
//     What its row says to people (core/titles). The name that is stored is made of it and is part
//     of the hash chain, so old rows must keep theirs.
//   EditDependencies dependencies(const X&, const DependencyFacts&)
//     What its result depends on; it may be too much, never too little (EditDependencies.h).
//   Result<EngineEdit> engineEdit(const X&, const Document&)
//     Only for those that the engine carries out: the command, in integers, that begins it.
//     Their effects name engineTask<X>(), which does not compile without this function.
//   std::unique_ptr<OpenStroke> openStroke(X&)
//     Only for those of these that can stand open until the user ends them: takes their further
//     input and passes it to the engine (core/edits/open/OpenStroke.h). It refers to the edit.
//     Null: this one is carried out whole, although others of its kind are not. Their effects name
//     opens<X>() or opensIf<X>() (Opening.h), which do not compile without this function.
//   OpenManner openManner(const X&)
//     Only for edits that the engine does not carry out alone and that stand open otherwise than
//     under a pen: edits of the surface, and those of a segment that are computed before they are
//     applied. Tools of the surface receive further points of their path (SurfacePath), which needs
//     no function.
//   RowUse rowUse(const X&)
//     Only for edits that name rows of the history: what it does with them (RowUse.h).
//     EditNames.cpp does not compile without this function.
//
// This header contains only what headers of edits need to declare them.

class OpenStroke;
struct DependencyFacts;
struct Document;
struct EditDependencies;
struct EditEffects;
struct EngineEdit;
struct OpenManner;
struct RowFacts;
struct RowTitle;
enum class RowUse;

} // namespace core
