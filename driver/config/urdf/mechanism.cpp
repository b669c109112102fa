// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/urdf/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cmath>

#include "driver/config/urdf/robot.hpp"
#include "records/json/diagnostics.hpp"
#include "support/files.hpp"
#include "support/nearest.hpp"

namespace kreisel::urdf {

namespace {

using boost::qvm::cross;
using boost::qvm::transposed;
using nlohmann::json;

json to_json(const Vector& v) { return {v.a[0], v.a[1], v.a[2]}; }
json to_json(const Matrix& M) {
    json rows = json::array();
    for (const auto& row : M.a) { rows.push_back({row[0], row[1], row[2]}); }
    return rows;
}

/// A link at the start, in space.
struct Placed {
    const Link* link;
    Pose frame;
    Vector omega = {0, 0, 0}, v = {0, 0, 0};  ///< of the frame, space axes, rad/s and m/s
    std::size_t carrier;                      ///< which of the placed links carries it rigidly, or itself
    const Joint* joint = nullptr;             ///< to its parent
    std::size_t parent = 0;
};

double value_of(const std::map<std::string, double>& values, const Joint& joint) {
    const auto found = values.find(joint.name);
    return found == values.end() ? 0 : found->second;
}

Placed carried(const Placed& parent, const Joint& joint, const Start& start) {
    Placed child{.link = nullptr, .frame = parent.frame * joint.origin, .carrier = 0};
    const Vector axis = child.frame.R * joint.axis;
    const double q = value_of(start.positions, joint), rate = value_of(start.rates, joint);
    if (joint.slides()) { child.frame.p = child.frame.p + axis * q; }
    child.v = parent.v + cross(parent.omega, child.frame.p - parent.frame.p);
    child.omega = parent.omega;
    if (joint.slides()) { child.v = child.v + axis * rate; }
    if (joint.turns()) {
        const Matrix turn = boost::qvm::rot_mat<3>(joint.axis, q);
        child.frame.R = child.frame.R * turn;
        child.omega = child.omega + axis * rate;
    }
    child.joint = &joint;
    return child;
}

/// Its links in space, parents before children.
class PlacedRobot {
  public:
    PlacedRobot(const Robot& robot, const Start& start, Complaints& complaints)
        : robot_(robot), start_(start), complaints_(complaints) {
        if (const Link* root = find_root()) {
            links_.push_back({.link = root, .frame = {}, .carrier = 0});
            for (std::size_t i = 0; i < links_.size(); ++i) { place_children(i); }
            if (links_.size() < robot.links.size()) { complaints.add(root->line, unreached()); }
        }
    }
    const std::vector<Placed>& links() const { return links_; }

  private:
    const Link* find_root() const {
        std::vector<const Link*> roots;
        for (const Link& link : robot_.links) {
            const bool is_child = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                              [&](const Joint& joint) { return joint.child == link.name; });
            if (!is_child) { roots.push_back(&link); }
        }
        if (roots.size() == 1) { return roots.front(); }
        std::string names;
        for (const Link* root : roots) { names += (names.empty() ? "" : ", ") + in_quotes(root->name); }
        complaints_.add(1, "expected one link that no joint carries, got " + (names.empty() ? "none" : names));
        return nullptr;
    }
    void place_children(std::size_t at) {
        for (const Joint& joint : robot_.joints) {
            if (joint.parent != links_[at].link->name) { continue; }
            Placed child = carried(links_[at], joint, start_);
            child.link = &*std::find_if(robot_.links.begin(), robot_.links.end(),
                                        [&](const Link& link) { return link.name == joint.child; });
            child.parent = at;
            child.carrier = joint.type == "fixed" ? links_[at].carrier : links_.size();
            links_.push_back(child);
        }
    }
    std::string unreached() const {
        std::string names;
        for (const Link& link : robot_.links) {
            const bool is_placed = std::any_of(links_.begin(), links_.end(),
                                               [&](const Placed& placed) { return placed.link->name == link.name; });
            if (!is_placed) { names += (names.empty() ? "" : ", ") + in_quotes(link.name); }
        }
        return fmt::format("expected joints that lead from {} to every link, got none to {}",
                           in_quotes(links_.front().link->name), names);
    }

    const Robot& robot_;
    const Start& start_;
    Complaints& complaints_;
    std::vector<Placed> links_;
};

/// Mass, mass centre and inertia about it, in space.
struct Whole {
    double mass = 0;
    Vector centre = {0, 0, 0};
    Matrix inertia = boost::qvm::zero_mat<double, 3>();
};

Whole with_link(const Whole& whole, const Placed& placed) {
    const Inertial& part = *placed.link->inertial;
    const Vector centre = placed.frame.p + placed.frame.R * part.centre;
    Whole all{.mass = whole.mass + part.mass};
    all.centre = (whole.centre * whole.mass + centre * part.mass) / all.mass;
    all.inertia = whole.inertia + of_unit_mass(whole.centre - all.centre) * whole.mass +
                  turned(placed.frame.R, part.inertia) + of_unit_mass(centre - all.centre) * part.mass;
    return all;
}

class Writer {
  public:
    Writer(const std::vector<Placed>& links, const Start& start, Complaints& complaints)
        : links_(links), start_(start), complaints_(complaints), wholes_(links.size()) {
        for (const Placed& placed : links) {
            if (placed.link->inertial) { wholes_[placed.carrier] = with_link(wholes_[placed.carrier], placed); }
        }
        root_is_ground_ = start.holds_root.value_or(!links.front().link->inertial);
    }

    json parameters() const {
        json bodies = json::array(), joints = json::array(), forces = json::array();
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (links_[i].carrier != i) { continue; }
            if (i > 0 || !root_is_ground_) { bodies.push_back(body(i)); }
            const Joint* joint = links_[i].joint;
            if (joint == nullptr || !joint->moves()) { continue; }
            joints.push_back(joint_of(i));
            if (joint->damping > 0) { forces.push_back(damper_of(i)); }
        }
        return {{"bodies", bodies}, {"joints", joints}, {"forces", forces}};
    }

  private:
    std::string name_of(std::size_t carrier) const {
        return carrier == 0 && root_is_ground_ ? "ground" : links_[carrier].link->name;
    }
    std::vector<std::string> ends_of(std::size_t i) const {
        return {name_of(links_[links_[i].parent].carrier), name_of(i)};
    }
    json body(std::size_t i) const {
        const Placed& placed = links_[i];
        const Whole& whole = wholes_[i];
        if (!(whole.mass > 0)) {
            complaints_.add(placed.link->line,
                            fmt::format("<link {}>: expected a mass, of it or of a link that is fixed to it, since it "
                                        "can move; got none",
                                        in_quotes(placed.link->name)));
            return {};
        }
        const Matrix back = transposed(placed.frame.R);
        json body = {{"name", placed.link->name},
                     {"mass", whole.mass},
                     {"inertia", to_json(turned(back, whole.inertia))},
                     {"x", to_json(whole.centre)},
                     {"R", to_json(placed.frame.R)}};
        if (const json shape = shape_of(i); !shape.is_null()) { body["shape"] = shape; }
        if (!start_.rates.empty()) {
            body["v"] = to_json(placed.v + cross(placed.omega, whole.centre - placed.frame.p));
            body["omega"] = to_json(back * placed.omega);
        }
        return body;
    }
    // From the mass centre to the farthest frame that the body carries, those of the joints at it among them, m.
    double reach_of(std::size_t i) const {
        double reach = 0;
        for (const Placed& placed : links_) {
            if (placed.carrier != i && links_[placed.parent].carrier != i) { continue; }
            reach = std::max(reach, boost::qvm::mag(placed.frame.p - wholes_[i].centre));
        }
        return reach;
    }
    // That which its description gives, of a body of one link that lies about its mass centre.
    json shape_given(std::size_t i) const {
        const Link& link = *links_[i].link;
        const bool is_alone = link.inertial && link.inertial->mass == wholes_[i].mass;
        return is_alone && link.solid ? shape_about(*link.solid, link.inertial->centre) : json();
    }
    // Descriptions of robots often give small links inertias that make the homogeneous solid far larger than the link.
    // Such a body is shown as a cylinder about the axis of its joint, as long as it reaches; one on an axle alone, as a
    // wheel, reaches nowhere.
    json shape_of(std::size_t i) const {
        if (json given = shape_given(i); !given.is_null()) { return given; }
        constexpr double many = 3, slenderness = 0.4;  // radii of gyration over the reach; radius over length
        const Whole& whole = wholes_[i];
        const double trace = whole.inertia.a[0][0] + whole.inertia.a[1][1] + whole.inertia.a[2][2];
        const double gyration = std::sqrt(trace / (2 * whole.mass)), reach = reach_of(i);
        const Joint* joint = links_[i].joint;
        if (joint == nullptr || !(reach > 0) || !(gyration > many * reach)) { return {}; }
        return {
            {"type", "cylinder"}, {"radius", slenderness * reach}, {"length", reach}, {"axis", to_json(joint->axis)}};
    }
    json joint_of(std::size_t i) const {
        const Placed& placed = links_[i];
        return {{"type", placed.joint->turns() ? "revolute" : "prismatic"},
                {"name", placed.joint->name},
                {"between", ends_of(i)},
                {"point", to_json(placed.frame.p)},
                {"axis", to_json(placed.frame.R * placed.joint->axis)}};
    }
    json damper_of(std::size_t i) const {
        const Joint& joint = *links_[i].joint;
        json damper = {{"between", ends_of(i)}, {"damping", joint.damping}};
        damper["type"] = joint.turns() ? "rotational_damper" : "damper";
        if (joint.slides()) { damper["point"] = to_json(links_[i].frame.p); }
        return damper;
    }

    const std::vector<Placed>& links_;
    const Start& start_;
    Complaints& complaints_;
    std::vector<Whole> wholes_;
    bool root_is_ground_;
};

// Coordinates belong to joints that have one.
void check_start(const std::map<std::string, double>& values, const char* key, const Robot& robot,
                 Complaints& complaints) {
    std::vector<std::string> names;
    for (const Joint& joint : robot.joints) {
        if (joint.moves()) { names.push_back(joint.name); }
    }
    for (const auto& entry : values) {
        if (std::find(names.begin(), names.end(), entry.first) != names.end()) { continue; }
        const std::string nearest = nearest_name(entry.first, names);
        complaints.add(1, fmt::format("{}: expected the name of a joint that turns or slides, got {}{}", key,
                                      in_quotes(entry.first),
                                      nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
    }
}

/// Complains of attributes that an element has twice, which the parser takes.
struct Doubles final : pugi::xml_tree_walker {
    explicit Doubles(Complaints& sink) : complaints(&sink) {}
    bool for_each(pugi::xml_node& node) override {
        for (const pugi::xml_attribute& one : node.attributes()) {
            if (node.attribute(one.name()) == one) { continue; }
            Element(node, *complaints).error(fmt::format("expected each attribute once, got {} twice", one.name()));
        }
        return true;
    }
    Complaints* complaints;
};

// Names become JSON, which has no other encoding.
void require_encoding(const std::string& text, Complaints& complaints) {
    const auto complain = [&](std::ptrdiff_t at, const std::string& got) {
        complaints.add(complaints.line_at(at), "expected UTF-8 text, got " + got);
    };
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        complain(static_cast<std::ptrdiff_t>(zero), "a zero byte");
    }
    for (auto at = text.begin(); at != text.end();) {
        const auto start = at;
        if (!boost::locale::utf::is_valid_codepoint(boost::locale::utf::utf_traits<char>::decode(at, text.end()))) {
            complain(start - text.begin(), fmt::format("the byte 0x{:02X}", static_cast<unsigned char>(*start)));
            break;
        }
    }
    complaints.raise();
}

// The parser takes any number of elements, and text between them.
void require_one_element(const pugi::xml_document& document, Complaints& complaints) {
    for (const pugi::xml_node& node : document.children()) {
        const bool is_text = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
        const bool is_second = node.type() == pugi::node_element && node != document.document_element();
        if (!is_text && !is_second) { continue; }
        complaints.add(complaints.line_at(node.offset_debug()),
                       "expected one element <robot>, got " + (is_text ? "text" : fmt::format("<{}>", node.name())) +
                           " beside it");
    }
    complaints.raise();
}

void parse(const std::string& text, pugi::xml_document& document, Complaints& complaints) {
    require_encoding(text, complaints);
    const auto result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
    if (!result) {
        complaints.add(complaints.line_at(result.offset),
                       fmt::format("expected XML, got an error: {}", result.description()));
    } else if (!document.document_element()) {
        complaints.add(1, "expected <robot>, got no element");
    }
    complaints.raise();
    require_one_element(document, complaints);
    Doubles doubles(complaints);
    document.traverse(doubles);
    complaints.raise();
}

}  // namespace

Mechanism read_mechanism(const std::filesystem::path& file, const Start& start) {
    const std::string text = read_text(file);
    Complaints complaints(file.string(), text);
    pugi::xml_document document;
    parse(text, document, complaints);
    const Robot robot = read_robot(Element(document.document_element(), complaints));
    complaints.raise();
    check_start(start.positions, "positions", robot, complaints);
    check_start(start.rates, "rates", robot, complaints);
    const PlacedRobot placed(robot, start, complaints);
    complaints.raise();
    json parameters = Writer(placed.links(), start, complaints).parameters();
    complaints.raise();
    return {std::move(parameters), complaints.remarks()};
}

}  // namespace kreisel::urdf
