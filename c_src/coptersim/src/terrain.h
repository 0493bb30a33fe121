// The line segments, and which of them reach into a box.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coptersim {

struct Line {
    std::int32_t id;
    double x1, y1, x2, y2;
    double mid_x, mid_y, length;
    double along_x, along_y; // unit vector; (1, 0) where both ends are equal
};

struct Place {
    double x, y;
};

Line make_line(std::int32_t id, double x1, double y1, double x2, double y2);

// The point of the segment closest to (x, y).
Place closest_point(const Line &line, double x, double y);

// A tree of boxes over the lines. A line's box also holds its risk ellipse at rest: `base` around
// it, and its length / length divisor along it from its middle.
class Terrain {
  public:
    const std::vector<Line> &lines() const {
        return lines_;
    }
    // By id; replaces.
    void add(const Line &line);
    void clear();
    int find(std::int32_t id) const; // index in lines(), or -1

    // Builds the tree when lines or measures have changed.
    void prepare(double base, double length_divisor);

    // Visits, in no particular order, every line whose box comes within `margin` of (x, y) in both
    // coordinates. After prepare.
    template <class Visit> void near(double x, double y, double margin, Visit visit) const {
        if (!nodes_.empty())
            visit_node(0, {x - margin, y - margin, x + margin, y + margin}, visit);
    }

  private:
    struct Box {
        double x1, y1, x2, y2;
    };
    struct Node {
        Box box;
        std::uint32_t begin, end; // in order_, when it is a leaf
        std::uint32_t right;      // the left child follows its parent; 0 in a leaf
    };

    static bool meet(const Box &a, const Box &b) {
        return a.x1 <= b.x2 && b.x1 <= a.x2 && a.y1 <= b.y2 && b.y1 <= a.y2;
    }
    template <class Visit> void visit_node(std::uint32_t at, const Box &box, Visit &visit) const {
        const Node &node = nodes_[at];
        if (!meet(node.box, box))
            return;
        if (node.right == 0) {
            for (std::uint32_t i = node.begin; i < node.end; ++i)
                if (meet(boxes_[order_[i]], box))
                    visit(order_[i]);
            return;
        }
        visit_node(at + 1, box, visit);
        visit_node(node.right, box, visit);
    }
    std::uint32_t build_node(std::uint32_t begin, std::uint32_t end);

    std::vector<Line> lines_; // in ascending order of id
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    bool stale_ = false;
    double base_ = 0, length_divisor_ = 1;
};

} // namespace coptersim
