// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/EglContext.h"

#include <memory>

namespace testing {

/// A headless OpenGL 4.5 debug context, current on this thread while the fixture lives.
///
/// Make it a member of the test class, construct nothing of GL before it, and call
/// `QVERIFY2(gl.isReady(), gl.why())` in initTestCase and `QCOMPARE(gl.newErrors(), 0)` in cleanup:
/// GL errors fail tests.
class GlFixture {
public:
    GlFixture();
    ~GlFixture();
    GlFixture(const GlFixture&) = delete;
    GlFixture& operator=(const GlFixture&) = delete;

    [[nodiscard]] bool isReady() const { return m_ready; }
    [[nodiscard]] const char* why() const { return m_why.constData(); }
    /// GL errors since the last call.
    [[nodiscard]] int newErrors();

private:
    std::unique_ptr<gpu::EglContext> m_context;
    bool m_ready = false;
    QByteArray m_why;
    int m_errorsSeen = 0;
};

} // namespace testing
