// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/FrameFixture.h"
#include "tests/support/GlTest.h"

#include <optional>

namespace test {

/// A test of renderers: every case has fresh ones.
class FrameTest : public GlTest {
    Q_OBJECT

protected:
    std::optional<FrameFixture> m_fixture;

private Q_SLOTS:
    void init() { m_fixture.emplace(); }
    void cleanup()
    {
        m_fixture.reset();
        failOnErrors();
    }
};

} // namespace test
