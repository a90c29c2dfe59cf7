// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"

#include <gtest/gtest.h>

using namespace agv;

// Expected numbers: the portable reference generator of the estimator study (vectors/splitmix.json, seed 0).
TEST(SplitMix64, givesTheReferenceBits)
{
    SplitMix64 random(0);
    EXPECT_EQ(random.next(), 16294208416658607535ULL);
    EXPECT_EQ(random.next(), 7960286522194355700ULL);
    EXPECT_EQ(random.next(), 487617019471545679ULL);
    EXPECT_EQ(random.next(), 17909611376780542444ULL);
}

TEST(SplitMix64, givesTheReferenceUniformsNormalsAndExponentials)
{
    SplitMix64 uniforms(0);
    EXPECT_DOUBLE_EQ(uniforms.uniform(), 0.8833108082136426);
    EXPECT_DOUBLE_EQ(uniforms.uniform(), 0.43152799704850997);
    SplitMix64 normals(0);
    EXPECT_NEAR(normals.normal(), -1.88390833335244, 1e-12);
    EXPECT_NEAR(normals.normal(), 0.22760793546360525, 1e-12);
    SplitMix64 exponentials(0);
    EXPECT_NEAR(exponentials.exponential(0.3), 0.6444724078045149, 1e-12);
}

TEST(SplitMix64, splitsIntoStreamsThatDiffer)
{
    const SplitMix64 parent(7);
    SplitMix64 first = parent.split(0);
    SplitMix64 again = parent.split(0);
    SplitMix64 second = parent.split(1);
    const std::uint64_t value = first.next();
    EXPECT_EQ(value, again.next());
    EXPECT_NE(value, second.next());
}
