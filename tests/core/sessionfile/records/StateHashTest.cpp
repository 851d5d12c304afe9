// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/StateHash.h"
#include "tests/support/program/TestProgram.h"

#include <QCryptographicHash>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <random>

namespace stateHashTest {

using namespace core;

namespace {

std::vector<std::uint8_t> filled(Field field, std::uint8_t value)
{
    return std::vector<std::uint8_t>(
        std::size_t(bytesPerVoxel(field)) * BrickGrid::voxelsPerBrick, value);
}

/// The definition of README.md, read again and computed from scratch by recursion over key
/// prefixes.
class ReferenceTree {
public:
    std::map<BrickKey, std::vector<std::uint8_t>> bricks;

    QByteArray root(const QByteArray& json) const
    {
        QByteArray message("\xFF"
                           "BurinState1");
        for (int field = 1; field <= 4; ++field) {
            for (int plane = 0; plane < 256; ++plane) {
                const QByteArray hash = node(field, plane, 0, 6);
                if (!hash.isEmpty())
                    message += QByteArray(1, char(field)) + QByteArray(1, char(plane)) + hash;
            }
        }
        message += '\xFF';
        return sha(message + json).toHex();
    }

private:
    static QByteArray sha(const QByteArray& message)
    {
        return QCryptographicHash::hash(message, QCryptographicHash::Sha256);
    }
    QByteArray node(int field, int plane, std::uint32_t first, int level) const
    {
        const std::uint32_t width = 1u << (4 * level);
        const auto key = [&](std::uint32_t brick) {
            return BrickKey{Field(field), std::uint8_t(plane), brick};
        };
        const auto begin = bricks.lower_bound(key(first));
        const auto end = bricks.lower_bound(key(first + width));
        if (begin == end)
            return {};
        if (level == 0) {
            QByteArray message;
            message += char(field);
            message += char(plane);
            for (int shift = 0; shift < 32; shift += 8)
                message += char(first >> shift);
            const std::vector<std::uint8_t>& bytes = begin->second;
            message.append(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
            return sha(message);
        }
        QByteArray message;
        message += '\0';
        message += char(level);
        for (std::uint32_t child = 0; child < 16; ++child) {
            const QByteArray hash = node(field, plane, first + child * (width / 16), level - 1);
            if (!hash.isEmpty())
                message += QByteArray(1, char(child)) + hash;
        }
        return sha(message);
    }
};

} // namespace

class StateHashTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void meetsTheWrittenVectors()
    {
        QFile readme(QStringLiteral(BURIN_SOURCE_DIR "/core/session/README.md"));
        QVERIFY(readme.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(readme.readAll());
        const auto written = [&text](int number) {
            const QRegularExpression line(
                QStringLiteral("\\| V%1 \\|.*`([0-9a-f]{64})` \\|").arg(number));
            return line.match(text).captured(1).toLatin1();
        };

        StateHash hash;
        QCOMPARE(hash.root("{}"), written(1));
        hash.update({BrickImage{{Field::Labels, 0, 0}, filled(Field::Labels, 1)}});
        QCOMPARE(hash.root("{}"), written(2));
        hash.update({BrickImage{{Field::SeedWords, 0, 0x123456}, filled(Field::SeedWords, 0)}});
        QCOMPARE(hash.root("{}"), written(3));
        QCOMPARE(hash.root("{\"segments\":[]}"), written(4));
        hash.update({BrickImage{{Field::Overwritten, 0, 0}, filled(Field::Overwritten, 2)}});
        QCOMPARE(hash.root("{}"), written(5));
        // What growth gave back leaves no trace.
        hash.update({BrickImage{{Field::Overwritten, 0, 0}, filled(Field::Overwritten, 0)}});
        QCOMPARE(hash.root("{}"), written(3));
    }

    void equalsTheDefinitionAfterManyUpdates()
    {
        std::mt19937 random(1);
        StateHash hash;
        ReferenceTree reference;
        const int rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 300 : 40;
        for (int round = 0; round < rounds; ++round) {
            std::vector<BrickChange> changes;
            std::map<BrickKey, bool> used;
            for (int i = 0; i < 10; ++i) {
                const Field field = Field(1 + random() % 4);
                const BrickKey key{field, std::uint8_t(random() % 2),
                    std::uint32_t(random() % 4 == 0 ? random() & 0xFFFFFF : random() % 300)};
                if (!used.emplace(key, true).second)
                    continue;
                BrickChange change{.key = key, .before = {}, .after = {}};
                if (random() % 3 == 0) {
                    reference.bricks.erase(key);
                    if (random() % 2 == 0) // all empty, spelled out
                        change.after = filled(field, emptyByte(field));
                } else {
                    change.after = filled(field, std::uint8_t(1 + random() % 200));
                    change.after.write()[random() % change.after.size()] = 201;
                    reference.bricks[key] = change.after.read();
                }
                changes.push_back(std::move(change));
            }
            hash.update(changes);
            QCOMPARE(hash.root("{\"a\":1}"), reference.root("{\"a\":1}"));
        }
    }

    void theWayDoesNotMatter()
    {
        const BrickImage a{{Field::Coverage, 1, 3}, filled(Field::Coverage, 9)};
        const BrickImage b{{Field::Coverage, 1, 4000}, filled(Field::Coverage, 8)};
        StateHash one;
        one.update({a, b});
        StateHash other;
        other.update({BrickImage{b.key, filled(Field::Coverage, 7)}});
        other.update({b});
        other.update({a});
        QCOMPARE(one.root("{}"), other.root("{}"));
        other.update({BrickImage{a.key, {}}, BrickImage{b.key, {}}});
        QCOMPARE(other.root("{}"), StateHash().root("{}"));
    }

    void everyPartCounts()
    {
        StateHash hash;
        hash.update({BrickImage{{Field::Coverage, 1, 3}, filled(Field::Coverage, 9)}});
        const QByteArray root = hash.root("{}");
        const auto rootOf = [](const BrickKey& key, std::uint8_t value) {
            StateHash other;
            other.update({BrickImage{key, filled(key.field, value)}});
            return other.root("{}");
        };
        QVERIFY(rootOf({Field::Labels, 1, 3}, 9) != root);
        QVERIFY(rootOf({Field::Coverage, 2, 3}, 9) != root);
        QVERIFY(rootOf({Field::Coverage, 1, 4}, 9) != root);
        QVERIFY(rootOf({Field::Coverage, 1, 3}, 8) != root);
        QVERIFY(hash.root("{ }") != root);
    }
};

BURIN_TEST(StateHashTest)

} // namespace stateHashTest

#include "StateHashTest.moc"
