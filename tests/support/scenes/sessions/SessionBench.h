// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace test {

/// A session with the oracle as its engine, for tests of one kind of edit.
class SessionBench {
public:
    /// @param delayed whether the engine delivers its results late
    explicit SessionBench(
        bool delayed, const core::LoadedVolume& volume = smallStudy(), const QString& file = {})
        : late(inner, 11)
        , session(*core::EditSession::create(
              delayed ? static_cast<core::EditEngine&>(late) : inner, volume, {.file = file}))
    {
    }

    /// Carries out an edit and waits for its end. A refusal fails the test.
    void run(const core::Edit& edit) const
    {
        const core::Result<void> done = carriedOut(edit);
        QVERIFY2(done, qPrintable(done ? QString() : done.error().arguments.join(u' ')));
    }
    /// The same, where it may be refused.
    [[nodiscard]] core::Result<void> carriedOut(const core::Edit& edit) const
    {
        const core::Result<void> done = session->apply(edit);
        return done ? session->settle() : done;
    }
    /// The same, but returns why it is refused; empty if it is not.
    [[nodiscard]] QString tried(const core::Edit& edit) const
    {
        const core::Result<void> done = carriedOut(edit);
        return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
    }
    /// Returns the error with which the session refuses an edit at once, before it is carried out;
    /// Internal if it does not.
    [[nodiscard]] core::ErrorCode refusal(const core::Edit& edit) const
    {
        const core::Result<void> applied = session->apply(edit);
        return applied ? core::ErrorCode::Internal : applied.error().code;
    }
    [[nodiscard]] const core::VolumeGeometry& geometry() const
    {
        return session->document().volumes.front().geometry;
    }
    [[nodiscard]] const std::vector<core::HistoryRow>& rows() const
    {
        return session->history().rows();
    }
    [[nodiscard]] std::vector<std::uint8_t> labels(int plane = 0) const
    {
        return *session->questions().labels(std::uint8_t(plane));
    }
    [[nodiscard]] std::int64_t voxels(int label = 1, int plane = 0) const
    {
        const std::vector<std::uint8_t> all = labels(plane);
        return std::count(all.begin(), all.end(), label);
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<core::EditSession> session;
};

} // namespace test
