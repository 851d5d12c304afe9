// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/EglContext.h"

#include <QObject>

#include <memory>

namespace test {

/// A test with a headless OpenGL 4.5 debug context, current on its thread from first to last.
/// A GL error fails the case that made it.
class GlTest : public QObject {
    Q_OBJECT

protected:
    GlTest();
    ~GlTest() override;

    /// GL errors since the last call.
    [[nodiscard]] int newErrors();
    void failOnErrors();

private Q_SLOTS:
    void initTestCase();
    void cleanup() { failOnErrors(); }

private:
    std::unique_ptr<gpu::EglContext> m_context;
    bool m_ready = false;
    QByteArray m_why;
    int m_errorsSeen = 0;
};

} // namespace test
