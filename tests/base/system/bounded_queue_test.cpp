// SPDX-License-Identifier: MIT
#include "base/system/bounded_queue.h"

#include <memory>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"

namespace polhode {
namespace {

TEST(BoundedQueue, GivesItemsInOrderAndThenEnds) {
  BoundedQueue<int> queue(2);
  const std::jthread producer([&] {
    for (int i = 0, place = 0; i < 100 && queue.wait_for_place(place); ++i)
      queue.push(int(i));
    queue.end();
  });
  int item = -1;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(queue.pop(item));
    EXPECT_EQ(item, i);
  }
  EXPECT_FALSE(queue.pop(item));
  EXPECT_FALSE(queue.pop(item)) << "and stays ended";
}

TEST(BoundedQueue, TheProducerIsNeverMoreThanItsLengthAhead) {
  BoundedQueue<int> queue(3);
  int place = 0, made = 0;
  for (; made < 3; ++made) {
    ASSERT_TRUE(queue.wait_for_place(place));
    queue.push(int(made));
  }
  std::jthread producer([&] {
    if (queue.wait_for_place(place)) ++made;
  });
  queue.stop();  // the producer waits for a place that never comes, or has not begun to
  producer.join();
  EXPECT_EQ(made, 3);
}

TEST(BoundedQueue, WhatIsGivenBackIsUsedAgain) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  std::unique_ptr<int> item;
  ASSERT_TRUE(queue.wait_for_place(item));
  EXPECT_EQ(item, nullptr) << "nothing was given back yet";
  item = std::make_unique<int>(7);
  const int* const address = item.get();
  queue.push(std::move(item));
  ASSERT_TRUE(queue.pop(item));
  queue.give_back(std::move(item));
  ASSERT_TRUE(queue.wait_for_place(item));
  EXPECT_EQ(item.get(), address);
}

TEST(BoundedQueue, WhatWasPushedIsNotGivenAgain) {
  BoundedQueue<int> queue(2);
  int item = 7;
  ASSERT_TRUE(queue.wait_for_place(item));
  EXPECT_EQ(item, 0) << "a new one, not what is left of the last";
}

TEST(BoundedQueue, AnErrorWaitsBehindTheItemsBeforeIt) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.end(std::make_exception_ptr(std::runtime_error("the source broke")));
  int item = 0;
  ASSERT_TRUE(queue.pop(item));
  EXPECT_EQ(item, 1);
  EXPECT_THROW(queue.pop(item), std::runtime_error);
}

TEST(BoundedQueue, StoppingLosesWhatWaits) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.stop();
  int item = 0;
  EXPECT_FALSE(queue.pop(item));
  EXPECT_FALSE(queue.wait_for_place(item));
}

}  // namespace
}  // namespace polhode
