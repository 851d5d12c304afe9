// SPDX-License-Identifier: Apache-2.0
#include "tests/support/GlFixture.h"

#include "gpu/gl/DebugOutput.h"

namespace testing {

GlFixture::GlFixture()
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

GlFixture::~GlFixture()
{
    if (m_context)
        m_context->doneCurrent();
}

int GlFixture::newErrors()
{
    const int total = gpu::DebugOutput::errorCount();
    const int fresh = total - m_errorsSeen;
    m_errorsSeen = total;
    return fresh;
}

} // namespace testing
