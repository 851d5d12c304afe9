// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/StateHash.h"

#include "core/base/Sha256.h"

#include <algorithm>

namespace core {

namespace {

constexpr int branchBits = 4;
constexpr int brickBits = 24;
constexpr std::uint8_t nodeMark = 0x00; // no field has this number, so no leaf begins with it
constexpr std::uint8_t rootMark = 0xFF;
constexpr char rootName[] = "BurinState1";

void add(Sha256& hash, std::uint8_t byte)
{
    hash.add(&byte, 1);
}

bool allEmpty(Field field, const std::vector<std::uint8_t>& bytes)
{
    const std::uint8_t empty = emptyByte(field);
    return std::all_of(
        bytes.begin(), bytes.end(), [empty](std::uint8_t byte) { return byte == empty; });
}

} // namespace

void StateHash::update(const std::vector<BrickImage>& bricks)
{
    std::vector<NodeKey> touched;
    for (const BrickImage& brick : bricks)
        setLeaf(brick.key, brick.bytes.read(), touched);
    updateAbove(std::move(touched));
}

void StateHash::update(const std::vector<BrickChange>& changes)
{
    std::vector<NodeKey> touched;
    for (const BrickChange& change : changes)
        setLeaf(change.key, change.after.read(), touched);
    updateAbove(std::move(touched));
}

void StateHash::setLeaf(
    const BrickKey& key, const std::vector<std::uint8_t>& bytes, std::vector<NodeKey>& touched)
{
    const NodeKey node = NodeKey(key.field) << 32 | NodeKey(key.plane) << brickBits | key.brick;
    touched.push_back(node);
    if (allEmpty(key.field, bytes)) {
        m_nodes[0].erase(node);
        return;
    }
    Sha256 hash;
    add(hash, std::uint8_t(key.field));
    add(hash, key.plane);
    for (int shift = 0; shift < 32; shift += 8)
        add(hash, std::uint8_t(key.brick >> shift));
    hash.add(bytes.data(), bytes.size());
    m_nodes[0][node] = hash.take();
}

void StateHash::updateAbove(std::vector<NodeKey> touched)
{
    for (std::size_t level = 1; level < m_nodes.size(); ++level) {
        for (NodeKey& key : touched)
            key >>= branchBits;
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        const std::map<NodeKey, Digest>& below = m_nodes[level - 1];
        for (const NodeKey key : touched) {
            const auto first = below.lower_bound(key << branchBits);
            const auto last = below.lower_bound((key + 1) << branchBits);
            if (first == last) {
                m_nodes[level].erase(key);
                continue;
            }
            Sha256 hash;
            add(hash, nodeMark);
            add(hash, std::uint8_t(level));
            for (auto child = first; child != last; ++child) {
                add(hash, std::uint8_t(child->first & ((1 << branchBits) - 1)));
                hash.add(child->second.data(), child->second.size());
            }
            m_nodes[level][key] = hash.take();
        }
    }
}

QByteArray StateHash::root(const QByteArray& documentJson) const
{
    Sha256 hash;
    add(hash, rootMark);
    hash.add(rootName, sizeof rootName - 1);
    for (const auto& [key, digest] : m_nodes.back()) {
        add(hash, std::uint8_t(key >> 8));
        add(hash, std::uint8_t(key));
        hash.add(digest.data(), digest.size());
    }
    add(hash, rootMark);
    hash.add(documentJson.constData(), std::size_t(documentJson.size()));
    const Digest digest = hash.take();
    return QByteArray(reinterpret_cast<const char*>(digest.data()), qsizetype(digest.size()))
        .toHex();
}

} // namespace core
