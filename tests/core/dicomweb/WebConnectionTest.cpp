// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebConnection.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/VerifyResult.h"
#include "tests/support/servers/WebServer.h"

#include <QTest>

#include <new>

namespace webConnectionTest {

using core::Clause;
using core::ErrorCode;
using core::Result;

namespace {

/// Has no memory for the first bytes, but would have for those that follow.
class ShortOfMemory : public core::WebSink {
public:
    Result<void> begin(const core::WebAnswer&) override { return {}; }
    Result<void> take(const QByteArray&) override
    {
        if (++m_calls == 1)
            throw std::bad_alloc();
        return {};
    }
    [[nodiscard]] int calls() const { return m_calls; }

private:
    int m_calls = 0;
};

} // namespace

/// One exchange, and what goes wrong on our side of it.
class WebConnectionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// What is thrown while bytes are taken ends the exchange: it does not pass through Qt's event
    /// loop, and nothing is put behind the gap.
    void whereMemoryRunsOutTheExchangeEnds()
    {
        const test::WebServer server([](const QByteArray&, const QByteArray&) {
            return test::WebReply{.body = QByteArray(200'000, ' '), .dripMs = 2};
        });
        core::WebNode node;
        node.url = server.url();
        node.timeoutSeconds = 10;
        node.retries = 2;
        node.firstPauseMs = 10;
        const core::Progress progress;
        auto connection = core::WebConnection::open(node, progress);
        QVERIFY(connection);
        ShortOfMemory sink;
        const auto answer = connection->get(
            "/studies", "application/dicom+json", Clause::saying("the search"), sink, true);
        VERIFY_ERROR(answer, ErrorCode::OutOfMemory);
        QCOMPARE(sink.calls(), 1);
        QCOMPARE(server.questions().size(), std::size_t(1)); // asking again would need no less
    }
};

BURIN_TEST(WebConnectionTest)

} // namespace webConnectionTest

#include "WebConnectionTest.moc"
