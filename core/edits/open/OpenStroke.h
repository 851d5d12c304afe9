// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/delta/Ending.h"

#include <vector>

namespace core {

struct Document;
struct EngineEdit;
struct EngineExtension;
struct EngineResult;
struct StrokeExtension;

/// How an edit stands open, whatever input it gets. The defaults are those of a stroke under a pen.
struct OpenManner {
    /// It stays open although no pen is down. Any next action then closes it.
    bool withoutPen = false;
    Ending usualEnding = Ending::Rollback; ///< how it ends if the user does not end it
    /// If the engine refuses to begin it, it ends at once, since no pen will be lifted.
    bool endsIfRefused = false;
    /// The engine keeps something for the next preview of this kind, until ForgetPreview.
    bool keepsForNext = false;
};

/// An edit that stands open until it is ended. Input of the user changes the edit and decides which
/// extensions the engine gets. Every kind of edit that the engine carries out and that can stand
/// open makes one of these in its own source (openStroke(), core/edits/answers/EditAnswers.h). The
/// code that carries the edit out knows nothing else about its kind.
///
/// It refers to the edit, which must outlive it and keep its kind. An edit that is complete when it
/// begins passes through begin(), lift() and carriedOut() as well.
class OpenStroke {
public:
    /// The extensions for the engine, in this order (ExtendEdit).
    using Told = std::vector<EngineExtension>;

    OpenStroke() = default;
    OpenStroke(const OpenStroke&) = delete;
    OpenStroke& operator=(const OpenStroke&) = delete;
    virtual ~OpenStroke() = default;

    [[nodiscard]] virtual OpenManner manner() const;

    /// Called once, when the engine begins the edit. @return what the edit already contains and the
    /// engine does not yet know: the path so far, a depth, the steps of a whole growth
    /// @param command with which the engine begins
    /// @param isWhole the edit is complete; false: the user continues it
    [[nodiscard]] virtual Told begin(
        const EngineEdit& command, const Document& document, bool isWhole);
    /// Called any number of times, also before begin(): input that comes while the edit waits in
    /// line is written into it, and is part of what begin() returns. Only requests that are no part
    /// of the edit, such as steps of a growth, are returned at once. What does not apply to this
    /// kind is ignored. Errors: those of the conversion for the engine.
    [[nodiscard]] virtual Result<Told> extend(
        const StrokeExtension& extension, const Document& document);
    /// Called before the engine ends the edit. @return the extensions that the engine must get
    /// first: the rest of a path. Before begin() there is none.
    [[nodiscard]] virtual Told lift();
    /// Called when the edit is done and becomes a row. Writes into it how far it came if only the
    /// engine knows, so that replay repeats it.
    virtual void carriedOut(const EngineResult& result, bool isWhole);
};

} // namespace core
