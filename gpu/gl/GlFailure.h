// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <cstddef>
#include <stdexcept>

namespace gpu {

/// The driver refused memory or a command. Thrown on the engine thread where storage is allocated,
/// and before the result of an edit or a picture is used. The code that runs a slice of that thread
/// catches it and takes back what was under way.
class GlFailure : public std::runtime_error {
public:
    explicit GlFailure(core::Error error);
    [[nodiscard]] const core::Error& error() const { return m_error; }

private:
    core::Error m_error;
};

/// The edit under way could not be taken back, so what the GPU holds is no longer known.
class FieldsLost : public GlFailure {
public:
    using GlFailure::GlFailure;
};

/// The driver has taken away the context of this thread, and with it every texture and buffer, for
/// instance because the graphics processor was reset. Nothing can be restored or done any more;
/// another context has to be made on another thread. Once it was detected, every function below
/// throws it. Error: ContextLost.
class ContextLost : public FieldsLost {
public:
    using FieldsLost::FieldsLost;
};

/// The exception that is being handled as an Error; call it only inside a catch block. Converts
/// GlFailure, ShaderError (to GraphicsUnavailable), and anything else as core::errorBeingHandled()
/// does. Throws nothing.
[[nodiscard]] core::Error errorBeingHandled() noexcept;

// Each function below also throws ContextLost, whatever else went wrong, because a failure in a
// lost context does not mean that memory is short.

/// Throws GlFailure (OutOfMemory, with what was allocated and how much) if a command has failed
/// since the last check. Call it after allocating storage.
void requireStorage(const char* label, std::size_t bytes);
/// Throws GlFailure (OutOfMemory) if a command has failed since the last check because memory ran
/// out. Call it before reporting another reason for a failure.
void requireMemory(const char* label);
/// Throws GlFailure (OutOfMemory or Internal) if a command has failed since the last check.
/// Commands that the GPU still executes may fail later.
void requireNoError();
/// Throws ContextLost only; other errors stay for the next check. Call it before passing on what
/// was read back, if the checks above come later.
void requireContext();

} // namespace gpu
