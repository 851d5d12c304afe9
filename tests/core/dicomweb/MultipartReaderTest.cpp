// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/MultipartReader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <vector>

namespace multipartReaderTest {

namespace {

/// Keeps all; a real one does not.
class Collected : public core::PartSink {
public:
    core::Result<void> beginPart() override
    {
        parts.emplace_back();
        return {};
    }
    core::Result<void> takePart(const char* bytes, qsizetype size) override
    {
        parts.back().append(bytes, size);
        return {};
    }
    core::Result<void> endPart() override
    {
        ++ended;
        return {};
    }

    std::vector<QByteArray> parts;
    int ended = 0;
};

} // namespace

/// Parts of a multipart body, however it is cut into pieces on its way.
class MultipartReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void everyCut();
    void lengthSays();
    void cutShort();
    void nonsense_data();
    void nonsense();
    void memoryIsBounded();
    void boundaries_data();
    void boundaries();
};

void MultipartReaderTest::everyCut()
{
    // The first part by its length, with the boundary in it. The second by the boundary.
    const QByteArray body = "--cut\r\nContent-Length: 12\r\n\r\n\r\n--cut\r\nabc\r\n--cut\r\n\r\n"
                            "x\r\n-\r\n--cu\r\r\n--cut--\r\nan epilogue";
    for (qsizetype first = 0; first <= body.size(); ++first) {
        for (qsizetype second = first; second <= body.size(); ++second) {
            Collected sink;
            core::MultipartReader reader("cut", QStringLiteral("node"), sink);
            QVERIFY(reader.feed(body.left(first)).has_value());
            QVERIFY(reader.feed(body.mid(first, second - first)).has_value());
            QVERIFY(reader.feed(body.mid(second)).has_value());
            QVERIFY(reader.isComplete());
            QCOMPARE(sink.parts, (std::vector<QByteArray>{"\r\n--cut\r\nabc", "x\r\n-\r\n--cu\r"}));
            QCOMPARE(sink.ended, 2);
        }
    }
}

void MultipartReaderTest::lengthSays()
{
    Collected sink;
    core::MultipartReader reader("b", QStringLiteral("node"), sink);
    QVERIFY(reader.feed("\r\n--b\r\ncontent-length:0\r\n\r\n\r\n--b--").has_value());
    QVERIFY(reader.isComplete());
    QCOMPARE(sink.parts, std::vector<QByteArray>{QByteArray()});
}

void MultipartReaderTest::cutShort()
{
    const QByteArray body = "--cut\r\n\r\nabc\r\n--cut--";
    for (qsizetype size = 0; size < body.size(); ++size) {
        Collected sink;
        core::MultipartReader reader("cut", QStringLiteral("node"), sink);
        QVERIFY(reader.feed(body.left(size)).has_value());
        QVERIFY(!reader.isComplete());
    }
}

void MultipartReaderTest::nonsense_data()
{
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("no part at all") << QByteArray(100000, 'x');
    QTest::newRow("another boundary") << QByteArray("--cutter\r\n\r\nabc\r\n--cutter--");
    QTest::newRow("a boundary without end") << "--cut" + QByteArray(100000, ' ');
    QTest::newRow("headers without end") << "--cut\r\n" + QByteArray(100000, 'h');
    QTest::newRow("headers of a megabyte")
        << "--cut\r\n" + QByteArray(1000000, 'h') + "\r\n\r\nabc\r\n--cut--";
    QTest::newRow("no number") << QByteArray("--cut\r\nContent-Length: x\r\n\r\nabc\r\n--cut--");
    QTest::newRow("below zero") << QByteArray("--cut\r\nContent-Length: -3\r\n\r\nabc\r\n--cut--");
    QTest::newRow("beyond all numbers")
        << QByteArray("--cut\r\nContent-Length: 99999999999999999999\r\n\r\nabc\r\n--cut--");
    QTest::newRow("too short a length")
        << QByteArray("--cut\r\nContent-Length: 2\r\n\r\nabcdefgh\r\n--cut--");
}

void MultipartReaderTest::nonsense()
{
    QFETCH(QByteArray, body);
    Collected sink;
    core::MultipartReader reader("cut", QStringLiteral("node"), sink);
    const core::Result<void> fed = reader.feed(body);
    QVERIFY(!fed.has_value());
    QVERIFY(fed.error().code == core::ErrorCode::NodeNonsense);
}

void MultipartReaderTest::memoryIsBounded()
{
    // Counts what it gets, which is more than any memory.
    class Counted : public core::PartSink {
    public:
        core::Result<void> beginPart() override { return {}; }
        core::Result<void> takePart(const char*, qsizetype size) override
        {
            bytes += size;
            most = std::max(most, size);
            return {};
        }
        core::Result<void> endPart() override { return {}; }
        qint64 bytes = 0;
        qsizetype most = 0;
    };
    Counted sink;
    core::MultipartReader reader("cut", QStringLiteral("node"), sink);
    QVERIFY(reader.feed("--cut\r\n\r\n").has_value());
    const QByteArray piece(1 << 16, '-');
    for (int i = 0; i < 1000; ++i)
        QVERIFY(reader.feed(piece).has_value());
    QVERIFY(sink.bytes > 1000 * piece.size() - 10);
    QVERIFY(sink.most < piece.size() + 10);
}

void MultipartReaderTest::boundaries_data()
{
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("boundary");
    QTest::newRow("plain") << QByteArray("multipart/related; boundary=abc; type=x")
                           << QByteArray("abc");
    QTest::newRow("quoted") << QByteArray(
        "Multipart/Related;type=\"application/dicom\";Boundary=\"a;b c\"")
                            << QByteArray("a;b c");
    QTest::newRow("none") << QByteArray("multipart/related; type=x") << QByteArray();
    QTest::newRow("empty") << QByteArray("multipart/related; boundary=\"\"") << QByteArray();
    QTest::newRow("endless") << "multipart/related; boundary=" + QByteArray(10000, 'b')
                             << QByteArray();
    QTest::newRow("no multipart") << QByteArray("text/html; boundary=abc") << QByteArray();
}

void MultipartReaderTest::boundaries()
{
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, boundary);
    QCOMPARE(core::MultipartReader::boundaryOf(type).value_or(QByteArray()), boundary);
}

BURIN_TEST(MultipartReaderTest)

} // namespace multipartReaderTest

#include "MultipartReaderTest.moc"
