// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

#include <functional>
#include <memory>

namespace core {

/// The line in which questions stand with edits (OperationQueue), as far as questions need it. One
/// thread.
class QuestionLine {
public:
    using Answer = std::function<void(EngineResult&&)>;

    virtual ~QuestionLine() = default;

    /// A question takes its place in line. The answer is given by poll(); what it throws is told to
    /// it once more, as an error.
    virtual void ask(EngineCommand question, Answer answer) = 0;
    virtual void submit(std::unique_ptr<Operation> operation) = 0;
    virtual void closeGrowth() = 0;
    /// Waits for the engine, then gives the answers that are there.
    virtual void waitForEngine() = 0;
    /// The document after what waits, as far as that can be told.
    [[nodiscard]] virtual Document foreseen() const = 0;
};

} // namespace core
