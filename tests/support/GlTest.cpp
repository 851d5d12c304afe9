// SPDX-License-Identifier: Apache-2.0
#include "tests/support/GlTest.h"

#include "gpu/gl/DebugOutput.h"

#include <QTest>

namespace test {

GlTest::GlTest()
{
    auto context = gpu::EglContext::create({.debug = true});
    if (!context) {
        m_why = context.error().arguments.join(QStringLiteral(": ")).toUtf8();
        return;
    }
    m_context = std::move(*context);
    m_ready = m_context->makeCurrent();
    if (!m_ready) {
        m_why = "the context cannot be made current";
        return;
    }
    gpu::DebugOutput::install();
    m_errorsSeen = gpu::DebugOutput::errorCount();
}

GlTest::~GlTest()
{
    if (m_context)
        m_context->doneCurrent();
}

int GlTest::newErrors()
{
    const int total = gpu::DebugOutput::errorCount();
    const int fresh = total - m_errorsSeen;
    m_errorsSeen = total;
    return fresh;
}

void GlTest::initTestCase()
{
    QVERIFY2(m_ready, m_why.constData());
}

void GlTest::failOnErrors()
{
    QCOMPARE(newErrors(), 0);
}

} // namespace test
