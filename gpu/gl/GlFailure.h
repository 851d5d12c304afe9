// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <cstddef>
#include <stdexcept>

namespace gpu {

/// The driver refused memory, or a command. Thrown on the engine thread where storage is made, and
/// before what an edit or a picture has written is believed. Whoever runs a slice of that thread
/// catches it and takes back what was under way.
class GlFailure : public std::runtime_error {
public:
    explicit GlFailure(core::Error error);
    [[nodiscard]] const core::Error& error() const { return m_error; }

private:
    core::Error m_error;
};

/// What was under way could not be taken back: what the GPU holds is no longer known.
class FieldsLost : public GlFailure {
public:
    using GlFailure::GlFailure;
};

/// The driver has given up the context of this thread, and with it every texture and buffer: it was
/// reset, or taken away. Nothing can be put back, nor done at all; another context has to be made,
/// on another thread. Once it was seen every look below throws it. Error: ContextLost.
class ContextLost : public FieldsLost {
public:
    using FieldsLost::FieldsLost;
};

/// What is being handled, as a value; only inside a catch block. GlFailure, ShaderError
/// (GraphicsUnavailable), anything else as core::errorBeingHandled() has it. Throws nothing.
[[nodiscard]] core::Error errorBeingHandled() noexcept;

// Each of these also throws ContextLost, whatever else went wrong: what a lost context does not
// give is no want of memory.

/// Throws GlFailure (OutOfMemory: what, and how much of it) where a command has failed since the
/// last look. Call it after making storage.
void requireStorage(const char* label, std::size_t bytes);
/// Throws GlFailure (OutOfMemory) where a command has failed since the last look because there was
/// no more memory. Call it before another reason is told for what did not come about.
void requireMemory(const char* label);
/// Throws GlFailure (OutOfMemory or Internal) where a command has failed since the last look.
/// Commands that the GPU still works on may fail later.
void requireNoError();
/// Throws ContextLost only; errors stay for the next look. Call it before what was read back is
/// handed on where the looks above come later.
void requireContext();

} // namespace gpu
