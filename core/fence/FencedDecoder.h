// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/fence/DecodeWorker.h"
#include "core/fence/WorkerProcess.h"

#include <functional>

namespace core {

/// The decoder processes of this program: as many as are needed at once, started when they are
/// first needed, ended and replaced when they fail. A decoder that fails costs one call.
///
/// The program that they run is set once, before the first call; `burin` sets itself. If it was not
/// set, nothing is decoded. Any thread may call.
class FencedDecoder {
public:
    /// The decoders of this process.
    [[nodiscard]] static FencedDecoder& instance();

    FencedDecoder();
    FencedDecoder(const FencedDecoder&) = delete;
    FencedDecoder& operator=(const FencedDecoder&) = delete;
    ~FencedDecoder();

    /// Ends the existing decoders.
    void setProgram(const WorkerProgram& program);
    /// For fuzzers and measurements: uses no processes, so a crash of @p work is a crash of the
    /// program.
    void decodeInside(FencedWork work);
    void setPatience(std::chrono::milliseconds patience);

    /// Does FencedWork on @p input in a decoder and passes the output to @p take, which must copy
    /// it.
    /// @return why it failed, in words; empty if it did not
    [[nodiscard]] Clause decode(std::span<const std::uint8_t> parameters,
        std::span<const std::uint8_t> input, std::size_t outputBytes,
        const std::function<void(std::span<const std::uint8_t> output)>& take);

    /// The processes that are waiting for work.
    [[nodiscard]] std::vector<pid_t> idle() const;

private:
    struct State;

    [[nodiscard]] std::unique_ptr<WorkerProcess> borrow(Clause& why);
    void giveBack(std::unique_ptr<WorkerProcess> worker);

    std::unique_ptr<State> m_state;
};

} // namespace core
