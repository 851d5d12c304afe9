// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

#include <functional>
#include <memory>

namespace core {

/// The queue in which questions wait together with edits (OperationQueue), as far as questions need
/// it. One thread.
class QuestionLine {
public:
    using Answer = std::function<void(EngineResult&&)>;

    virtual ~QuestionLine() = default;

    /// Appends a question. poll() calls @p answer; if that throws, it is called once more with an
    /// error.
    virtual void ask(EngineCommand question, Answer answer) = 0;
    virtual void submit(std::unique_ptr<Operation> operation) = 0;
    virtual void closeOpen() = 0;
    /// Blocks until the engine is done, then delivers the answers.
    virtual void waitForEngine() = 0;
    /// The document after everything that is waiting, as far as that is known.
    [[nodiscard]] virtual Document foreseen() const = 0;
};

} // namespace core
