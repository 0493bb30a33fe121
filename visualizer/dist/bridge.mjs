/*
This file contains ws:

Copyright (c) 2011 Einar Otto Stangvik <einaros@gmail.com>
Copyright (c) 2013 Arnout Kazemier and contributors
Copyright (c) 2016 Luigi Pinca and contributors

Permission is hereby granted, free of charge, to any person obtaining a copy of
this software and associated documentation files (the "Software"), to deal in
the Software without restriction, including without limitation the rights to
use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of
the Software, and to permit persons to whom the Software is furnished to do so,
subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS
FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER
IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN
CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { constants, existsSync, linkSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { randomBytes, timingSafeEqual } from "node:crypto";
import { dirname, join, sep } from "node:path";
import { open, readdir, realpath } from "node:fs/promises";
import { parseArgs } from "node:util";
import { createSocket } from "node:dgram";
import { networkInterfaces } from "node:os";
import { createServer } from "node:http";
import { pipeline } from "node:stream/promises";
// \0rolldown/runtime.js
var __create = Object.create;
var __defProp = Object.defineProperty;
var __getOwnPropDesc = Object.getOwnPropertyDescriptor;
var __getOwnPropNames = Object.getOwnPropertyNames;
var __getProtoOf = Object.getPrototypeOf;
var __hasOwnProp = Object.prototype.hasOwnProperty;
var __commonJSMin = (cb, mod) => () => (mod || (cb((mod = { exports: {} }).exports, mod, mod.exports), cb = null), mod.exports);
var __copyProps = (to, from, except, desc) => {
	if (from && typeof from === "object" || typeof from === "function") for (var keys = __getOwnPropNames(from), i = 0, n = keys.length, key; i < n; i++) {
		key = keys[i];
		if (!__hasOwnProp.call(to, key) && key !== except) __defProp(to, key, {
			get: ((k) => from[k]).bind(null, key),
			enumerable: !(desc = __getOwnPropDesc(from, key)) || desc.enumerable
		});
	}
	return to;
};
var __toESM = (mod, isNodeMode, target) => (target = mod != null ? __create(__getProtoOf(mod)) : {}, __copyProps(isNodeMode || !mod || !mod.__esModule || !__hasOwnProp.call(mod, "default") ? __defProp(target, "default", {
	value: mod,
	enumerable: true
}) : target, mod));
var __require = /* #__PURE__ */ (() => createRequire(import.meta.url))();
// ../lcm/ack.lcm?raw
var ack_default = "// Channel VIZ_ACK, the player's answer to one control message.\npackage viz;\n\nstruct ack {\n    string client;\n    int32_t seq;\n    int8_t ok;\n    string text; // one line: what was wrong, \"\" if nothing\n}\n";
// ../lcm/anchor.lcm?raw
var anchor_default = "// A fixed station that vehicles range to.\npackage viz;\n\nstruct anchor {\n    int32_t id;\n    float pos[3]; // m\n}\n";
// ../lcm/case_info.lcm?raw
var case_info_default = "// Channel VIZ_CASE, at the start and once a second: which case this is. (`case' alone is a word of C++.)\npackage viz;\n\nstruct case_info {\n    string case_id;\n    string property;\n    string seed;\n    string code_version;\n    int32_t ncmd_original; // before shrinking\n    int32_t ncmd;\n    command commands[ncmd];\n    string params; // JSON object\n}\n";
// ../lcm/command.lcm?raw
var command_default = "// One command of a test case.\npackage viz;\n\nstruct command {\n    int64_t t_us;  // simulated time at which it begins\n    int32_t index; // from 0\n    string name;\n    string args;   // Erlang terms, as in the stored case, without the brackets of the list\n}\n";
// ../lcm/control.lcm?raw
var control_default = "// Channel VIZ_CONTROL, from a page, through the bridge, to the player.\npackage viz;\n\nstruct control {\n    string client; // given by the bridge\n    string token;\n    int32_t seq;   // chosen by the client\n    string verb;\n    int32_t object; // id, -1: none or all\n    int32_t nargs;\n    double args[nargs];\n    string text;\n}\n";
// ../lcm/ellipse.lcm?raw
var ellipse_default = "// One risk contour.\npackage viz;\n\nstruct ellipse {\n    int32_t about; // id of the object; number of the line when kind is 1\n    int8_t kind;   // 0 object, 1 terrain\n    int8_t overlap; // 1: reaches into the observer's comfort zone\n    float x;       // m, centre\n    float y;       // m\n    float rx;      // m, semi-axis along theta\n    float ry;      // m, the other semi-axis\n    float theta;   // rad, counter-clockwise from east\n    float age;     // s since the information was sent\n}\n";
// ../lcm/event.lcm?raw
var event_default = "// Channel VIZ_EVENT, as it happens.\npackage viz;\n\nstruct event {\n    int64_t t_us;\n    int32_t run;\n    int32_t seq;  // one more with each event of a run\n    string kind;  // command, fault, collision, verdict or log\n    int32_t a;    // object, -1: none; command: its index\n    int32_t b;    // second object, line of terrain, -1: none\n    float x;      // m, where\n    float y;      // m\n    string text;  // one line\n}\n";
// ../lcm/fault.lcm?raw
var fault_default = "// One injected fault.\npackage viz;\n\nstruct fault {\n    int32_t object; // id, -1: all\n    string probe;\n    string type;    // fault model, as docs/faults.md calls it\n    string params;  // JSON object\n    int64_t from_us;\n    int64_t to_us;  // -1: no end known\n    int8_t active;\n    int32_t hits;   // how many values or packets it has changed, -1: not known\n}\n";
// ../lcm/faults.lcm?raw
var faults_default = "// Channel VIZ_FAULTS, on change and once a second: all faults of the run so far.\npackage viz;\n\nstruct faults {\n    int64_t t_us;\n    int32_t run;\n    int32_t n;\n    fault items[n];\n}\n";
// ../lcm/frame.lcm?raw
var frame_default = "// Channel VIZ_FRAME, 60 times a second of wall time while playing.\npackage viz;\n\nstruct frame {\n    int64_t t_us; // simulated\n    int32_t run;  // one more at each start; messages of another run are not meant for this one\n    int32_t seq;  // one more with each frame of a run\n    int32_t n;\n    object objects[n]; // in ascending order of id\n}\n";
// ../lcm/object.lcm?raw
var object_default = "// One vehicle at one moment. World frame: x east, y north, z up; SI units, radians.\npackage viz;\n\nstruct object {\n    int32_t id;\n    int8_t kind;  // 0 copter, 1 car, 2 other\n    int8_t flags; // sum of 1 collided, 2 avoiding, 4 faulted, 8 stale, 16 steered by hand\n\n    float pos[3]; // m, true\n    float vel[3]; // m/s, true\n    float yaw;    // rad, counter-clockwise from east\n    float roll;   // rad\n    float pitch;  // rad\n\n    float pos_est[3]; // m, as the vehicle perceives it\n    float vel_est[3]; // m/s\n\n    float comfort;  // m, radius of the comfort zone\n    float steer[2]; // rad: roll and pitch set; car: steering angle, unused\n}\n";
// ../lcm/poly.lcm?raw
var poly_default = "// An area or a route on the map.\npackage viz;\n\nstruct poly {\n    string name;\n    int8_t role; // 0 allowed, 1 forbidden, 2 route, 3 recovery\n    int32_t npt;\n    float pt[npt][3]; // m\n}\n";
// ../lcm/range.lcm?raw
var range_default = "// One measured distance.\npackage viz;\n\nstruct range {\n    int32_t anchor;  // id\n    float measured;  // m\n    float expected;  // m, from the perceived position\n    int8_t used;     // 1: corrected the position; 0: refused\n}\n";
// ../lcm/ranges.lcm?raw
var ranges_default = "// Channel VIZ_RANGE, ten times a second, of the observer only.\npackage viz;\n\nstruct ranges {\n    int64_t t_us;\n    int32_t run;\n    int32_t object; // id\n    int32_t n;\n    range items[n];\n}\n";
// ../lcm/risk.lcm?raw
var risk_default = "// Channel VIZ_RISK, with each frame: the risk contours that one object, the observer, reckons with.\npackage viz;\n\nstruct risk {\n    int64_t t_us;\n    int32_t run;\n    int32_t observer; // id, -1: none chosen\n    int32_t n;\n    ellipse ellipses[n];\n}\n";
// ../lcm/status.lcm?raw
var status_default = "// Channel VIZ_STATUS, five times a second and on change.\npackage viz;\n\nstruct status {\n    int8_t mode;   // 0 idle, 1 live, 2 replay\n    int8_t paused; // 1: yes\n    float speed;   // simulated seconds per second\n    int64_t t_us;\n    int64_t duration_us; // -1: not known\n    int32_t run;\n    int8_t verdict; // 0 running, 1 passed, 2 failed, 3 differs from what is recorded\n    int8_t control_allowed;\n    string message; // one line for people, \"\" for none\n}\n";
// ../lcm/world.lcm?raw
var world_default = "// Channel VIZ_WORLD, on change and once a second: what does not move.\npackage viz;\n\nstruct world {\n    int32_t run;\n    int32_t version; // one more with each change\n    int32_t nseg;\n    float seg[nseg][4]; // m: x1, y1, x2, y2 of a line of terrain\n    int32_t nanchor;\n    anchor anchors[nanchor];\n    int32_t npoly;\n    poly polys[npoly];\n}\n";
// codec/bytes.ts
var decoder = new TextDecoder("utf-8", { ignoreBOM: true });
var encoder = new TextEncoder();
var BadBytes = class extends Error {};
var Reader = class {
	view;
	at;
	end;
	bytes;
	constructor(bytes, at = 0) {
		this.bytes = bytes;
		this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
		this.at = at;
		this.end = bytes.byteLength;
	}
	get left() {
		return this.end - this.at;
	}
	take(size, what) {
		const at = this.at;
		if (size > this.end - at) throw new BadBytes(`${what} at byte ${at}: needs ${size}, ${this.left} are left`);
		this.at = at + size;
		return at;
	}
	int8(what) {
		return this.view.getInt8(this.take(1, what));
	}
	int16(what) {
		return this.view.getInt16(this.take(2, what));
	}
	int32(what) {
		return this.view.getInt32(this.take(4, what));
	}
	int64(what) {
		const at = this.take(8, what);
		const value = this.view.getInt32(at) * 2 ** 32 + this.view.getUint32(at + 4);
		if (!Number.isSafeInteger(value)) throw new BadBytes(`${what} at byte ${at}: beyond 2^53`);
		return value;
	}
	float(what) {
		return this.view.getFloat32(this.take(4, what));
	}
	double(what) {
		return this.view.getFloat64(this.take(8, what));
	}
	string(what) {
		const at = this.at;
		const size = this.int32(what);
		if (size < 1 || size > this.left) throw new BadBytes(`${what} at byte ${at}: length ${size}, ${this.left} bytes are left`);
		const start = this.take(size, what);
		if (this.bytes[start + size - 1] !== 0) throw new BadBytes(`${what} at byte ${at}: no NUL at the end`);
		return decoder.decode(this.bytes.subarray(start, start + size - 1));
	}
};
var Writer = class {
	buffer = /* @__PURE__ */ new Uint8Array(256);
	view = new DataView(this.buffer.buffer);
	size = 0;
	room(size) {
		const at = this.size;
		this.size += size;
		if (this.size > this.buffer.length) {
			const larger = new Uint8Array(Math.max(this.size, 2 * this.buffer.length));
			larger.set(this.buffer);
			this.buffer = larger;
			this.view = new DataView(larger.buffer);
		}
		return at;
	}
	int8(value) {
		const at = this.room(1);
		this.view.setInt8(at, value);
	}
	int16(value) {
		const at = this.room(2);
		this.view.setInt16(at, value);
	}
	int32(value) {
		const at = this.room(4);
		this.view.setInt32(at, value);
	}
	int64(value) {
		this.uint64(BigInt(value));
	}
	uint64(value) {
		const at = this.room(8);
		this.view.setBigUint64(at, BigInt.asUintN(64, value));
	}
	float(value) {
		const at = this.room(4);
		this.view.setFloat32(at, value);
	}
	double(value) {
		const at = this.room(8);
		this.view.setFloat64(at, value);
	}
	string(value) {
		const text = encoder.encode(value);
		this.int32(text.length + 1);
		this.raw(text);
		this.int8(0);
	}
	raw(bytes) {
		const at = this.room(bytes.length);
		this.buffer.set(bytes, at);
	}
	bytes() {
		return this.buffer.slice(0, this.size);
	}
};
// codec/frame.ts
var objectSize = 78;
function readObject(view, at) {
	const f = (offset) => view.getFloat32(at + offset);
	return {
		id: view.getInt32(at),
		kind: view.getInt8(at + 4),
		flags: view.getInt8(at + 5),
		pos: [
			f(6),
			f(10),
			f(14)
		],
		vel: [
			f(18),
			f(22),
			f(26)
		],
		yaw: f(30),
		roll: f(34),
		pitch: f(38),
		posEst: [
			f(42),
			f(46),
			f(50)
		],
		velEst: [
			f(54),
			f(58),
			f(62)
		],
		comfort: f(66),
		steer: [f(70), f(74)]
	};
}
function decodeFrame(payload) {
	const reader = new Reader(payload, 8);
	const tUs = reader.int64("frame.t_us");
	const run = reader.int32("frame.run");
	const seq = reader.int32("frame.seq");
	const n = reader.int32("frame.n");
	if (n < 0 || n * objectSize !== reader.left) throw new BadBytes(`frame.objects: ${n} of ${objectSize} bytes, ${reader.left} bytes are left`);
	const objects = [];
	for (let at = reader.at; at < reader.end; at += objectSize) objects.push(readObject(reader.view, at));
	return {
		tUs,
		run,
		seq,
		objects
	};
}
// codec/risk.ts
var ellipseSize = 30;
function readEllipse(view, at) {
	const f = (offset) => view.getFloat32(at + offset);
	return {
		about: view.getInt32(at),
		kind: view.getInt8(at + 4),
		overlap: view.getInt8(at + 5) !== 0,
		x: f(6),
		y: f(10),
		rx: f(14),
		ry: f(18),
		theta: f(22),
		age: f(26)
	};
}
function decodeRisk(payload) {
	const reader = new Reader(payload, 8);
	const tUs = reader.int64("risk.t_us");
	const run = reader.int32("risk.run");
	const observer = reader.int32("risk.observer");
	const n = reader.int32("risk.n");
	if (n < 0 || n * ellipseSize !== reader.left) throw new BadBytes(`risk.ellipses: ${n} of ${ellipseSize} bytes, ${reader.left} bytes are left`);
	const ellipses = [];
	for (let at = reader.at; at < reader.end; at += ellipseSize) ellipses.push(readEllipse(reader.view, at));
	return {
		tUs,
		run,
		observer,
		ellipses
	};
}
// codec/fingerprint.ts
var signed = (v) => BigInt.asIntN(64, v);
var utf8 = new TextEncoder();
function mixNumber(hash, byte) {
	const c = BigInt(byte > 127 ? byte - 256 : byte);
	return signed((hash << 8n ^ hash >> 55n) + c);
}
function mixText(hash, text) {
	const bytes = utf8.encode(text);
	return bytes.reduce(mixNumber, mixNumber(hash, bytes.length));
}
function ownHash(struct) {
	let hash = 305419896n;
	for (const { name, type, primitive, dimensions } of struct.members) {
		hash = mixText(hash, name);
		if (primitive) hash = mixText(hash, type);
		hash = mixNumber(hash, dimensions.length);
		for (const { text, fixed } of dimensions) hash = mixText(mixNumber(hash, fixed === null ? 1 : 0), text);
	}
	return hash;
}
function fingerprint(name, types, within = []) {
	if (within.includes(name)) return 0n;
	const struct = types.get(name);
	if (!struct) throw new Error(`${within.at(-1) ?? "fingerprint"}: no type ${name}`);
	const sum = struct.members.filter(({ primitive }) => !primitive).reduce((hash, { type }) => hash + fingerprint(type, types, [...within, name]), ownHash(struct));
	const hash = BigInt.asUintN(64, sum);
	return BigInt.asUintN(64, (hash << 1n) + (hash >> 63n));
}
// codec/lcm_syntax.ts
var primitives = [
	"int8_t",
	"int16_t",
	"int32_t",
	"int64_t",
	"float",
	"double",
	"string",
	"boolean",
	"byte"
];
var isPrimitive = (type) => primitives.includes(type);
function tokens(text) {
	return text.replace(/\/\*[\s\S]*?\*\//g, " ").replace(/\/\/[^\n]*/g, " ").match(/[A-Za-z_][\w.]*|\d+|[^\s]/g) ?? [];
}
var Parser = class {
	at = 0;
	words;
	file;
	pkg = "";
	constructor(text, file) {
		this.words = tokens(text);
		this.file = file;
	}
	structs() {
		const found = [];
		while (this.at < this.words.length) {
			const word = this.next("\"package\" or \"struct\"");
			if (word === "package") {
				this.pkg = this.name();
				this.sign(";");
			} else if (word === "struct") found.push(this.struct());
			else this.fail("\"package\" or \"struct\"", word);
		}
		return found;
	}
	struct() {
		const name = this.qualified(this.name());
		const members = [];
		this.sign("{");
		while (!this.skip("}")) members.push(...this.declaration());
		for (const member of members) this.checkCounts(member, members);
		return {
			name,
			members
		};
	}
	declaration() {
		const word = this.name();
		if (word === "const" || word === "enum") this.fail("a member", word);
		const primitive = isPrimitive(word);
		const type = primitive ? word : this.qualified(word);
		const members = [];
		do
			members.push({
				name: this.name(),
				type,
				primitive,
				dimensions: this.dimensions()
			});
		while (this.skip(","));
		this.sign(";");
		return members;
	}
	dimensions() {
		const found = [];
		while (this.skip("[")) {
			const text = this.next("a dimension");
			if (!/^(\d+|[A-Za-z_]\w*)$/.test(text)) this.fail("a dimension", text);
			found.push({
				text,
				fixed: /^\d/.test(text) ? Number(text) : null
			});
			this.sign("]");
		}
		return found;
	}
	checkCounts(member, all) {
		for (const { text, fixed } of member.dimensions) {
			if (fixed !== null) continue;
			const count = all.slice(0, all.indexOf(member)).find(({ name }) => name === text);
			if (!count || !/^int(8|16|32|64)_t$/.test(count.type) || count.dimensions.length > 0) this.fail(`a whole number "${text}" before "${member.name}"`, "none");
		}
	}
	qualified(name) {
		return name.includes(".") || this.pkg === "" ? name : `${this.pkg}.${name}`;
	}
	name() {
		const word = this.next("a name");
		return /^[A-Za-z_]/.test(word) ? word : this.fail("a name", word);
	}
	next(wanted) {
		const word = this.words[this.at];
		if (word === void 0) return this.fail(wanted, "the end");
		this.at += 1;
		return word;
	}
	skip(sign) {
		if (this.words[this.at] !== sign) return false;
		this.at += 1;
		return true;
	}
	sign(sign) {
		const word = this.next(`"${sign}"`);
		if (word !== sign) this.fail(`"${sign}"`, word);
	}
	fail(wanted, got) {
		throw new Error(`${this.file}: expected ${wanted}, got ${got}`);
	}
};
function parseTypes(text, file) {
	return new Parser(text, file).structs();
}
// codec/schema.ts
var fewest = {
	int8_t: 1,
	boolean: 1,
	byte: 1,
	int16_t: 2,
	int32_t: 4,
	int64_t: 8,
	float: 4,
	double: 8,
	string: 5
};
var camelCase = (name) => name.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
var Schema = class {
	structs = /* @__PURE__ */ new Map();
	layouts = /* @__PURE__ */ new Map();
	flags;
	constructor(files, flags = []) {
		this.flags = new Set(flags);
		for (const [file, text] of files) for (const struct of parseTypes(text, file)) this.structs.set(struct.name, struct);
	}
	names() {
		return [...this.structs.keys()];
	}
	fingerprint(name) {
		return this.layout(name).fingerprint;
	}
	decode(name, payload) {
		const reader = new Reader(payload, 8);
		const value = this.readStruct(this.layout(name), reader);
		if (reader.left > 0) throw new BadBytes(`${name}: ${reader.left} bytes too many`);
		return value;
	}
	encode(name, value) {
		const writer = new Writer();
		writer.uint64(this.layout(name).fingerprint);
		this.writeStruct(this.layout(name), value, writer);
		return writer.bytes();
	}
	layout(name) {
		const known = this.layouts.get(name);
		if (known) return known;
		const struct = this.structs.get(name);
		if (!struct) throw new Error(`no type ${name}`);
		const layout = {
			name,
			fields: [],
			size: 0,
			fingerprint: fingerprint(name, this.structs)
		};
		this.layouts.set(name, layout);
		for (const member of struct.members) {
			const field = this.field(struct, member);
			layout.fields.push(field);
			const fixed = member.dimensions.map((d) => d.fixed ?? 0).reduce((a, b) => a * b, 1);
			layout.size += fixed * field.itemSize;
		}
		return layout;
	}
	field(struct, member) {
		const short = `${struct.name.replace(/^.*\./, "")}.${member.name}`;
		const counted = (count) => {
			const array = struct.members.find(({ dimensions }) => dimensions[0]?.text === count);
			return array ? camelCase(array.name) : null;
		};
		return {
			member,
			dimensions: member.dimensions.map(({ fixed, text }) => ({
				fixed,
				count: text,
				countedKey: counted(text) ?? camelCase(member.name)
			})),
			key: camelCase(member.name),
			path: short,
			flag: this.flags.has(short),
			countedKey: counted(member.name),
			itemSize: member.primitive ? fewest[member.type] : this.layout(member.type).size
		};
	}
	readStruct(layout, reader) {
		const value = {};
		const counts = /* @__PURE__ */ new Map();
		for (const field of layout.fields) {
			const read = this.readDimension(field, 0, counts, reader);
			if (field.countedKey !== null) counts.set(field.member.name, read);
			else value[field.key] = read;
		}
		return value;
	}
	readDimension(field, depth, counts, reader) {
		const dimension = field.dimensions[depth];
		if (!dimension) return this.readItem(field, reader);
		const count = dimension.fixed ?? counts.get(dimension.count) ?? 0;
		const size = field.dimensions.slice(depth + 1).reduce((n, d) => n * (d.fixed ?? 1), field.itemSize);
		if (count < 0 || count * size > reader.left) throw new BadBytes(`${field.path} at byte ${reader.at}: ${count} items in ${reader.left} bytes`);
		const items = [];
		for (let i = 0; i < count; i += 1) items.push(this.readDimension(field, depth + 1, counts, reader));
		return items;
	}
	readItem(field, reader) {
		const { type, primitive } = field.member;
		if (!primitive) return this.readStruct(this.layout(type), reader);
		switch (type) {
			case "int8_t": return field.flag ? reader.int8(field.path) !== 0 : reader.int8(field.path);
			case "boolean": return reader.int8(field.path) !== 0;
			case "byte": return reader.int8(field.path) & 255;
			case "int16_t": return reader.int16(field.path);
			case "int32_t": return reader.int32(field.path);
			case "int64_t": return reader.int64(field.path);
			case "float": return reader.float(field.path);
			case "double": return reader.double(field.path);
			case "string": return reader.string(field.path);
		}
	}
	writeStruct(layout, value, writer) {
		for (const field of layout.fields) {
			const { countedKey } = field;
			const written = countedKey === null ? value[field.key] : length(value[countedKey], field);
			this.writeDimension(field, 0, written, value, writer);
		}
	}
	writeDimension(field, depth, value, owner, writer) {
		const dimension = field.dimensions[depth];
		if (!dimension) {
			this.writeItem(field, value, writer);
			return;
		}
		const count = dimension.fixed ?? length(owner[dimension.countedKey], field);
		if (!Array.isArray(value) || value.length !== count) throw new Error(`${field.path}: expected an array of ${count}`);
		for (const item of value) this.writeDimension(field, depth + 1, item, owner, writer);
	}
	writeItem(field, value, writer) {
		const { type, primitive } = field.member;
		if (!primitive) {
			if (typeof value !== "object" || Array.isArray(value)) throw new Error(`${field.path}: expected an object`);
			this.writeStruct(this.layout(type), value, writer);
		} else if (type === "string") {
			if (typeof value !== "string") throw new Error(`${field.path}: expected a string`);
			writer.string(value);
		} else writeNumber(type, toNumber(field, value), writer);
	}
};
function length(value, field) {
	if (!Array.isArray(value)) throw new Error(`${field.path}: expected the array that it counts`);
	return value.length;
}
var bits = {
	int8_t: 8,
	int16_t: 16,
	int32_t: 32,
	int64_t: 64
};
function toNumber(field, value) {
	const number = typeof value === "boolean" ? Number(value) : value;
	if (typeof number !== "number") throw new Error(`${field.path}: expected a number`);
	const width = bits[field.member.type];
	if (width !== void 0 && !(Number.isSafeInteger(number) && number < 2 ** (width - 1) && number >= -(2 ** (width - 1)))) throw new Error(`${field.path}: ${number} is no ${field.member.type}`);
	return number;
}
function writeNumber(type, value, writer) {
	if (type === "int16_t") writer.int16(value);
	else if (type === "int32_t") writer.int32(value);
	else if (type === "int64_t") writer.int64(value);
	else if (type === "float") writer.float(value);
	else if (type === "double") writer.double(value);
	else writer.int8(value);
}
var vizSchema = new Schema(Object.entries(/* @__PURE__ */ Object.assign({
	"../../lcm/ack.lcm": ack_default,
	"../../lcm/anchor.lcm": anchor_default,
	"../../lcm/case_info.lcm": case_info_default,
	"../../lcm/command.lcm": command_default,
	"../../lcm/control.lcm": control_default,
	"../../lcm/ellipse.lcm": ellipse_default,
	"../../lcm/event.lcm": event_default,
	"../../lcm/fault.lcm": fault_default,
	"../../lcm/faults.lcm": faults_default,
	"../../lcm/frame.lcm": frame_default,
	"../../lcm/object.lcm": object_default,
	"../../lcm/poly.lcm": poly_default,
	"../../lcm/range.lcm": range_default,
	"../../lcm/ranges.lcm": ranges_default,
	"../../lcm/risk.lcm": risk_default,
	"../../lcm/status.lcm": status_default,
	"../../lcm/world.lcm": world_default
})), [
	"ellipse.overlap",
	"range.used",
	"fault.active",
	"status.paused",
	"status.control_allowed",
	"ack.ok"
]);
var channelTypes = {
	VIZ_FRAME: "viz.frame",
	VIZ_RISK: "viz.risk",
	VIZ_WORLD: "viz.world",
	VIZ_RANGE: "viz.ranges",
	VIZ_FAULTS: "viz.faults",
	VIZ_EVENT: "viz.event",
	VIZ_CASE: "viz.case_info",
	VIZ_STATUS: "viz.status",
	VIZ_ACK: "viz.ack"
};
var controlChannel = "VIZ_CONTROL";
var controlType = "viz.control";
Object.keys(channelTypes);
var isChannel = (name) => Object.hasOwn(channelTypes, name);
var fingerprints = new Map(Object.values(channelTypes).map((type) => [type, vizSchema.fingerprint(type)]));
function decodeMessage(channel, payload) {
	if (!isChannel(channel)) return {
		ok: false,
		error: `${channel}: no channel of the visualizer`
	};
	const type = channelTypes[channel];
	if (payload.byteLength < 8) return {
		ok: false,
		error: `${channel}: ${payload.byteLength} bytes hold no fingerprint`
	};
	if (fingerprintOf(payload) !== fingerprints.get(type)) return {
		ok: false,
		error: `${channel}: type mismatch: rebuild (${type} has another layout here)`
	};
	try {
		return {
			ok: true,
			message: {
				channel,
				value: decodeValue(channel, payload)
			}
		};
	} catch (error) {
		if (error instanceof BadBytes) return {
			ok: false,
			error: `${channel}: ${error.message}`
		};
		throw error;
	}
}
var fingerprintOf = (payload) => new DataView(payload.buffer, payload.byteOffset, 8).getBigUint64(0);
function decodeValue(channel, payload) {
	if (channel === "VIZ_FRAME") return decodeFrame(payload);
	if (channel === "VIZ_RISK") return decodeRisk(payload);
	return vizSchema.decode(channelTypes[channel], payload);
}
function encodeControl(control) {
	return vizSchema.encode(controlType, control);
}
// bridge/group.ts
var groupName = ({ host, port }) => `${host}:${port}`;
var defaultBuffer = 2097152;
function parseAddress(text) {
	const match = /^(\d{1,3})\.(\d{1,3})\.(\d{1,3})\.(\d{1,3}):(\d{1,5})$/.exec(text);
	const numbers = match?.slice(1).map(Number) ?? [];
	const [first = 256, , , , port = 0] = numbers;
	if (!match || numbers.slice(0, 4).some((part) => part > 255) || port < 1 || port > 65535) return `expected ADDRESS:PORT with an IPv4 address, got "${text}"`;
	return {
		host: numbers.slice(0, 4).join("."),
		port,
		first
	};
}
function parseNumber(name, text, otherwise, max) {
	if (text === null) return otherwise;
	if (/^\d{1,10}$/.test(text) && Number(text) <= max) return Number(text);
	return `${name}: expected a whole number from 0 to ${max}, got "${text}"`;
}
function parseGroup(text, network) {
	const [address = "", query = ""] = text.replace(/^udpm:\/\//, "").split("?");
	const place = parseAddress(address);
	if (typeof place === "string") return place;
	if (place.first < 224 || place.first > 239) return `expected a multicast address, 224 to 239, got ${place.host}`;
	const values = new URLSearchParams(query);
	const unknown = [...values.keys()].find((key) => key !== "ttl" && key !== "recv_buf_size");
	if (unknown !== void 0) return `expected ttl and recv_buf_size, got "${unknown}"`;
	const ttl = parseNumber("ttl", values.get("ttl"), 0, 255);
	const receiveBuffer = parseNumber("recv_buf_size", values.get("recv_buf_size"), defaultBuffer, 2 ** 30);
	if (typeof ttl === "string") return ttl;
	if (typeof receiveBuffer === "string") return receiveBuffer;
	if (ttl > 0 && !network) return `ttl=${ttl} would leave this host; needs --allow-network`;
	return {
		host: place.host,
		port: place.port,
		multicast: true,
		ttl,
		receiveBuffer,
		network
	};
}
function parseUnicast(text, network) {
	const place = parseAddress(text);
	if (typeof place === "string") return place;
	if (place.first !== 127 && !network) return `${place.host} is not on this host alone; needs --allow-network`;
	const { host, port } = place;
	return {
		host,
		port,
		multicast: false,
		ttl: 0,
		receiveBuffer: defaultBuffer,
		network
	};
}
var mercatorEdge = 85.0511287798066;
var longestAttribution = 200;
function parseTileSet(value) {
	if (typeof value !== "object" || value === null || Array.isArray(value)) return "expected a JSON object";
	const { origin, minzoom, maxzoom, attribution = "" } = value;
	if (!isPlace(origin)) return `origin: expected [longitude, latitude] in degrees, within 180 and ${mercatorEdge}, ${got(origin)}`;
	if (!isZoom(minzoom, 0)) return `minzoom: expected a whole number from 0 to 30, ${got(minzoom)}`;
	if (!isZoom(maxzoom, minzoom)) return `maxzoom: expected a whole number from ${minzoom} (minzoom) to 30, ${got(maxzoom)}`;
	if (typeof attribution !== "string" || !isLine(attribution)) return `attribution: expected one line of at most ${longestAttribution} characters, ${got(attribution)}`;
	return {
		origin,
		minzoom,
		maxzoom,
		attribution
	};
}
function isPlace(value) {
	if (!Array.isArray(value) || value.length !== 2) return false;
	const [longitude, latitude] = value;
	return within(longitude, 180) && within(latitude, 85.0511287798066);
}
var within = (value, most) => typeof value === "number" && Math.abs(value) <= most;
var isZoom = (value, least) => Number.isInteger(value) && value >= least && value <= 30;
var isLine = (text) => text.length <= longestAttribution && !/\p{Cc}/u.test(text);
function got(value) {
	return value === void 0 ? "got none" : `got ${JSON.stringify(value).slice(0, 60)}`;
}
// codec/protocol.ts
var subprotocol$1 = "viz.v1";
var maxRequestBytes = 4096;
var helloChannels = channelTypes;
new TextDecoder("latin1");
function wrap(channel, payload) {
	const bytes = new Uint8Array(1 + channel.length + payload.length);
	bytes[0] = channel.length;
	for (let i = 0; i < channel.length; i += 1) bytes[1 + i] = channel.charCodeAt(i);
	bytes.set(payload, 1 + channel.length);
	return bytes;
}
var isRecord = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
function parseJson(text) {
	try {
		const value = JSON.parse(text);
		return isRecord(value) ? value : null;
	} catch {
		return null;
	}
}
function parseRequest(text) {
	if (text.length > 4096) return `a request of more than ${maxRequestBytes} bytes`;
	const value = parseJson(text);
	if (!value) return "a request is one JSON object";
	const { seq, verb, object, args, text: words, token } = value;
	if (!isInt32(seq) || seq < 0) return "seq: expected a whole number from 0";
	if (typeof verb !== "string") return "verb: expected a string";
	if (!isInt32(object) || object < -1) return "object: expected a whole number from -1";
	if (!Array.isArray(args) || !args.every((arg) => Number.isFinite(arg))) return "args: expected an array of finite numbers";
	if (typeof words !== "string") return "text: expected a string";
	if (typeof token !== "string") return "token: expected a string";
	return {
		seq,
		verb,
		object,
		args,
		text: words,
		token
	};
}
var isInt32 = (value) => Number.isInteger(value) && value === (value | 0);
// codec/verbs.ts
var metres = 1e5;
var tilt = Math.PI / 2;
var nothing = {
	args: [],
	object: "none",
	text: "none"
};
var verbs = {
	play: nothing,
	pause: nothing,
	restart: nothing,
	speed: {
		...nothing,
		args: [{
			name: "factor",
			min: .05,
			max: 20
		}]
	},
	step: {
		...nothing,
		args: [{
			name: "frames",
			min: -1e5,
			max: 1e5,
			whole: true
		}]
	},
	seek: {
		...nothing,
		args: [{
			name: "seconds",
			min: 0,
			max: 1e6
		}]
	},
	loop: {
		...nothing,
		args: [{
			name: "from (s)",
			min: 0,
			max: 1e6
		}, {
			name: "to (s)",
			min: 0,
			max: 1e6
		}]
	},
	observe: {
		...nothing,
		object: "one or all"
	},
	load: {
		...nothing,
		text: "case",
		args: [{
			name: "original",
			min: 0,
			max: 1,
			whole: true
		}]
	},
	steer: {
		args: [
			{
				name: "roll (rad)",
				min: -tilt,
				max: tilt
			},
			{
				name: "pitch (rad)",
				min: -tilt,
				max: tilt
			},
			{
				name: "yaw rate (rad/s)",
				min: -10,
				max: 10
			}
		],
		object: "one",
		text: "none"
	},
	set: {
		args: [{
			name: "value",
			min: -1e9,
			max: 1e9
		}],
		object: "one or all",
		text: "name"
	},
	inject: {
		args: [],
		object: "one or all",
		text: "json"
	},
	clear_faults: {
		args: [],
		object: "one or all",
		text: "json or none"
	},
	add_object: {
		...nothing,
		args: [{
			name: "x (m)",
			min: -1e5,
			max: metres
		}, {
			name: "y (m)",
			min: -1e5,
			max: metres
		}]
	},
	remove_object: {
		...nothing,
		object: "one"
	},
	scenario: {
		...nothing,
		text: "file"
	},
	fork: nothing,
	stop_all: nothing
};
var caseIdPattern = /^[A-Za-z0-9_-]{1,64}$/;
var textRules = {
	none: {
		fits: (text) => text === "",
		wanted: "no text"
	},
	case: {
		fits: (text) => caseIdPattern.test(text),
		wanted: "a case id: 1 to 64 letters, digits, - and _"
	},
	file: {
		fits: (text) => /^[A-Za-z0-9_-][A-Za-z0-9_.-]{0,63}$/.test(text),
		wanted: "a file name without a folder"
	},
	name: {
		fits: (text) => /^[A-Za-z0-9_.-]{1,64}$/.test(text),
		wanted: "a name: 1 to 64 letters, digits, . - and _"
	},
	json: {
		fits: isJsonObject,
		wanted: "a JSON object"
	},
	"json or none": {
		fits: (text) => text === "" || isJsonObject(text),
		wanted: "a JSON object or nothing"
	}
};
function isJsonObject(text) {
	try {
		const value = JSON.parse(text);
		return typeof value === "object" && value !== null && !Array.isArray(value);
	} catch {
		return false;
	}
}
function checkVerb({ verb, object, args, text }) {
	const rule = Object.hasOwn(verbs, verb) ? verbs[verb] : void 0;
	if (!rule) return `verb: expected one of ${Object.keys(verbs).join(", ")}`;
	if (rule.object === "one" && object < 0) return `${verb}: expected an object`;
	if (args.length !== rule.args.length) return `${verb}: expected ${rule.args.length} arguments, got ${args.length}`;
	for (const [i, argument] of rule.args.entries()) {
		const problem = checkArgument(argument, args[i] ?? NaN);
		if (problem) return `${verb}: ${problem}`;
	}
	const { fits, wanted } = textRules[rule.text];
	return fits(text) ? "" : `${verb}: text: expected ${wanted}`;
}
function checkArgument({ name, min, max, whole }, value) {
	const kind = whole ? "a whole number" : "a number";
	return value >= min && value <= max && (!whole || Number.isInteger(value)) ? "" : `${name}: expected ${kind} from ${+min.toFixed(4)} to ${+max.toFixed(4)}, got ${value}`;
}
// bridge/token.ts
var pattern = /^[0-9a-f]{32,128}$/i;
function read(file) {
	const token = readFileSync(file, "utf8").trim();
	if (!pattern.test(token)) throw new Error(`${file}: expected 32 to 128 hexadecimal digits`);
	if ((statSync(file).mode & 63) !== 0) throw new Error(`${file}: others may read it; run: chmod 600 ${file}`);
	return token;
}
function make(file) {
	const temporary = `${file}.${process.pid}`;
	writeFileSync(temporary, `${randomBytes(32).toString("hex")}\n`, {
		mode: 384,
		flag: "wx"
	});
	try {
		linkSync(temporary, file);
	} catch (error) {
		if (error.code !== "EEXIST") throw error;
	} finally {
		rmSync(temporary);
	}
}
function sharedToken(file) {
	mkdirSync(dirname(file), { recursive: true });
	if (!existsSync(file)) make(file);
	return read(file);
}
function sameToken(given, token) {
	const a = Buffer.from(given);
	const b = Buffer.from(token);
	return a.length === b.length && timingSafeEqual(a, b);
}
// bridge/client.ts
var slowBytes = 1048576;
var deadBytes = 33554432;
var droppable = /* @__PURE__ */ new Set([
	"VIZ_FRAME",
	"VIZ_RISK",
	"VIZ_RANGE"
]);
var requestsPerSecond = 50;
var refusalsBorne = 100;
var Client = class {
	name;
	dropped = 0;
	socket;
	journal;
	token;
	waiting = /* @__PURE__ */ new Map();
	requests = new Budget(requestsPerSecond, requestsPerSecond);
	refusals = new Budget(refusalsBorne, 1);
	constructor(socket, name, token, journal, events) {
		this.socket = socket;
		this.name = name;
		this.token = token;
		this.journal = journal;
		socket.on("message", (data, binary) => this.request(data, binary, events));
		socket.on("close", () => events.closed(this));
		socket.on("error", (error) => journal.refused("request", `${name}: ${error.message}`));
	}
	hello(hello) {
		this.socket.send(JSON.stringify(hello));
	}
	text(message) {
		if (this.socket.bufferedAmount < deadBytes) this.socket.send(JSON.stringify(message));
	}
	forward(channel, message) {
		if (droppable.has(channel) && this.socket.bufferedAmount > slowBytes) {
			if (this.waiting.has(channel)) this.dropped += 1;
			this.waiting.set(channel, message);
			return;
		}
		if (this.socket.bufferedAmount > deadBytes) {
			this.journal.refused("request", `${this.name} reads nothing: closed`);
			this.socket.terminate();
			return;
		}
		if (this.waiting.delete(channel)) this.dropped += 1;
		this.send(message);
	}
	close() {
		this.socket.close(1001, "the bridge ends");
	}
	terminate() {
		this.socket.terminate();
	}
	send(message) {
		this.socket.send(message, () => this.catchUp());
	}
	catchUp() {
		if (this.waiting.size === 0 || this.socket.bufferedAmount > slowBytes) return;
		const held = [...this.waiting.values()];
		this.waiting.clear();
		for (const message of held) this.send(message);
	}
	request(data, binary, events) {
		if (binary) return this.refuse(-1, "a binary message, expected text");
		if (data.length > 4096) return this.refuse(-1, `a request of more than ${maxRequestBytes} bytes`);
		if (!this.requests.take()) return this.refuse(-1, `more than ${requestsPerSecond} requests a second`);
		const request = parseRequest(data.toString("utf8"));
		if (typeof request === "string") return this.refuse(-1, request);
		const problem = this.problemOf(request);
		if (problem) return this.refuse(request.seq, problem);
		events.control(this, request);
	}
	problemOf(request) {
		if (this.token === null) return "control is off: start bridge and player with --allow-control";
		if (!sameToken(request.token, this.token)) return "a wrong token: load the page again";
		return checkVerb(request);
	}
	refuse(seq, text) {
		this.journal.refused("control", `${this.name}: ${text}`);
		const refused = {
			seq,
			text
		};
		this.text({ refused });
		if (!this.refusals.take()) this.socket.close(1008, "too many requests were refused");
	}
};
var Budget = class {
	left;
	filledMs = performance.now();
	most;
	perSecond;
	constructor(most, perSecond) {
		this.most = most;
		this.perSecond = perSecond;
		this.left = most;
	}
	take() {
		const now = performance.now();
		this.left = Math.min(this.most, this.left + (now - this.filledMs) / 1e3 * this.perSecond);
		this.filledMs = now;
		if (this.left < 1) return false;
		this.left -= 1;
		return true;
	}
};
// bridge/newest.ts
var kept = [
	"VIZ_WORLD",
	"VIZ_CASE",
	"VIZ_FAULTS",
	"VIZ_STATUS"
];
var maxEvents = 2e4;
var maxEventBytes = 16777216;
var Newest = class {
	latest = /* @__PURE__ */ new Map();
	events = /* @__PURE__ */ new Map();
	eventBytes = 0;
	run = null;
	note(channel, payload) {
		if (channel === "VIZ_EVENT") return this.noteEvent(payload);
		if (!kept.includes(channel)) return "";
		const decoded = decodeMessage(channel, payload);
		if (!decoded.ok) return decoded.error;
		this.latest.set(channel, wrap(channel, payload));
		if (decoded.message.channel === "VIZ_STATUS") this.noteRun(decoded.message.value.run);
		return "";
	}
	all() {
		return [...kept.flatMap((channel) => this.latest.get(channel) ?? []), ...this.events.values()];
	}
	noteEvent(payload) {
		const decoded = decodeMessage("VIZ_EVENT", payload);
		if (!decoded.ok) return decoded.error;
		if (decoded.message.channel !== "VIZ_EVENT") return "";
		const { run, seq } = decoded.message.value;
		this.noteRun(run);
		if (this.events.has(seq)) return "";
		const event = wrap("VIZ_EVENT", payload);
		this.events.set(seq, event);
		this.eventBytes += event.length;
		for (const [oldest, { length }] of this.events) {
			if (this.events.size <= maxEvents && this.eventBytes <= maxEventBytes) break;
			this.events.delete(oldest);
			this.eventBytes -= length;
		}
		return "";
	}
	noteRun(run) {
		if (run === this.run) return;
		this.run = run;
		this.events.clear();
		this.eventBytes = 0;
	}
};
var Hub = class {
	options;
	clients = /* @__PURE__ */ new Set();
	newest = new Newest();
	start = (/* @__PURE__ */ new Date()).toISOString();
	named = 0;
	bytesBefore = 0;
	constructor(options) {
		this.options = options;
	}
	get size() {
		return this.clients.size;
	}
	get full() {
		return this.clients.size >= 128;
	}
	add(socket) {
		const { token, tiles, journal, group } = this.options;
		this.named += 1;
		const client = new Client(socket, `page-${this.named}`, token, journal, {
			control: (from, request) => {
				if (!this.options.control(from.name, request)) from.refuse(request.seq, "no player has been heard yet");
			},
			closed: (gone) => this.clients.delete(gone)
		});
		this.clients.add(client);
		client.hello({
			v: 1,
			start: this.start,
			control: token !== null,
			token,
			client: client.name,
			group,
			tiles,
			channels: { ...helloChannels }
		});
		for (const message of this.newest.all()) client.forward("", message);
	}
	message(channel, payload) {
		if (!isChannel(channel)) return;
		const problem = this.newest.note(channel, payload);
		if (problem) this.options.journal.refused("packet", problem);
		const message = wrap(channel, payload);
		for (const client of this.clients) client.forward(channel, message);
	}
	statistics({ messages, bytes, lost }) {
		const bytesPerSec = bytes - this.bytesBefore;
		this.bytesBefore = bytes;
		for (const client of this.clients) {
			const stats = {
				udp: messages,
				lost,
				dropped: client.dropped,
				bytesPerSec
			};
			client.text({ stats });
		}
	}
	close() {
		for (const client of this.clients) client.close();
	}
	terminate() {
		for (const client of this.clients) client.terminate();
	}
};
// bridge/inside.ts
async function openInside(folder, path) {
	try {
		const inside = await realpath(folder) + sep;
		const real = await realpath(join(folder, path));
		if (!real.startsWith(inside)) return "refused";
		const file = await open(real, constants.O_RDONLY | constants.O_NOFOLLOW | constants.O_NONBLOCK);
		const found = await file.stat();
		if (found.isFile()) return {
			file,
			size: found.size
		};
		await file.close();
		return "refused";
	} catch (error) {
		const { code } = error;
		return code === "ENOENT" || code === "ENOTDIR" ? "missing" : "refused";
	}
}
// bridge/options.ts
var UsageError = class extends Error {};
var usage = `bridge.mjs: passes LCM messages on to web pages, and what pages ask of the player back

  node bridge.mjs [--port 8765] [--bind 127.0.0.1] [--group URL | --udp 127.0.0.1:7667]
                  [--cases DIR] [--tiles DIR] [--page FILE] [--allow-control --token-file FILE]

  --port N       of the web server, 0 to 65535; 0 takes a free one, and the first line printed names it (8765)
  --bind ADDR    IPv4 address of the web server (127.0.0.1)
  --group URL    multicast group: udpm://239.255.76.67:7667?ttl=0 or 239.255.76.67:7667; --lcm-url is the same
  --udp ADDR     unicast on this address instead; the tools of LCM do not see that
  --cases DIR    folder of stored cases (cases); /cases lists those with a run.lcm
  --tiles DIR    folder of map tiles, Z/X/Y.png (or jpg, webp), with a tiles.json; none are ever fetched elsewhere
  --page FILE    the page to serve (page.html beside this program)
  --allow-control              pages may control the player, with a token of this file
  --token-file FILE            shared with the player; whoever comes first makes it
  --allow-network              take a URL with ttl > 0, and messages of other hosts
  --insecure-remote-control    take --allow-control together with a --bind that other hosts reach

Exit status: 0 ended by --help or SIGTERM, 2 usage, 3 an address or a file cannot be used, 130 interrupted.`;
var definition = {
	port: {
		type: "string",
		default: "8765"
	},
	bind: {
		type: "string",
		default: "127.0.0.1"
	},
	group: { type: "string" },
	"lcm-url": { type: "string" },
	udp: { type: "string" },
	cases: {
		type: "string",
		default: "cases"
	},
	tiles: { type: "string" },
	page: { type: "string" },
	"token-file": { type: "string" },
	"allow-control": {
		type: "boolean",
		default: false
	},
	"allow-network": {
		type: "boolean",
		default: false
	},
	"insecure-remote-control": {
		type: "boolean",
		default: false
	},
	help: {
		type: "boolean",
		short: "h",
		default: false
	}
};
var defaultGroup = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152";
function parsed(argv) {
	try {
		return parseArgs({
			args: argv,
			options: definition,
			strict: true,
			allowPositionals: false
		}).values;
	} catch (error) {
		throw new UsageError(firstLine(error));
	}
}
var firstLine = (error) => String(error.message).split("\n")[0] ?? "";
function wholeNumber(name, text, max) {
	const value = /^\d{1,9}$/.test(text) ? Number(text) : NaN;
	if (!(value <= max)) throw new UsageError(`${name}: expected a whole number from 0 to ${max}, got "${text}"`);
	return value;
}
var isLoopback = (address) => /^127\./.test(address);
function address(text) {
	const parts = text.split(".");
	if (!(parts.length === 4 && parts.every((part) => /^\d{1,3}$/.test(part) && Number(part) <= 255))) throw new UsageError(`--bind: expected an IPv4 address, got "${text}"`);
	return text;
}
function chosenGroup(values) {
	const network = values["allow-network"] ?? false;
	const url = values.group ?? values["lcm-url"];
	if (values.udp !== void 0 && url !== void 0) throw new UsageError("--udp and --group: expected one of them, got both");
	const group = values.udp !== void 0 ? parseUnicast(values.udp, network) : parseGroup(url ?? defaultGroup, network);
	if (typeof group === "string") throw new UsageError(`${values.udp !== void 0 ? "--udp" : "--group"}: ${group}`);
	return group;
}
function parseOptions(argv) {
	const values = parsed(argv);
	if (values.help) return null;
	const bind = address(values.bind ?? "");
	const control = values["allow-control"] ?? false;
	if (control && !isLoopback(bind) && !values["insecure-remote-control"]) throw new UsageError(`--allow-control with --bind ${bind}: other hosts would control; needs --insecure-remote-control`);
	if (control !== (values["token-file"] !== void 0)) throw new UsageError("--allow-control and --token-file: expected both or none, got one");
	return {
		port: wholeNumber("--port", values.port ?? "", 65535),
		bind,
		group: chosenGroup(values),
		cases: values.cases ?? "cases",
		tiles: values.tiles ?? null,
		page: values.page ?? null,
		tokenFile: values["token-file"] ?? null
	};
}
// bridge/tiles.ts
var types = /* @__PURE__ */ new Map([
	["png", "image/png"],
	["jpg", "image/jpeg"],
	["jpeg", "image/jpeg"],
	["webp", "image/webp"]
]);
function readTileFolder(folder) {
	const name = join(folder, "tiles.json");
	const wrong = (line) => new UsageError(`--tiles: ${name}: ${line}`);
	const value = parsedJson(name, wrong);
	const set = parseTileSet(value);
	if (typeof set === "string") throw wrong(set);
	const { format = "png", scheme = "xyz" } = value;
	if (typeof format !== "string" || !types.has(format)) throw wrong(`format: expected ${[...types.keys()].join(", ")}, got ${JSON.stringify(format)}`);
	if (scheme !== "xyz" && scheme !== "tms") throw wrong(`scheme: expected xyz or tms, got ${JSON.stringify(scheme)}`);
	return {
		folder,
		set,
		extension: format,
		fromSouth: scheme === "tms"
	};
}
function parsedJson(name, wrong) {
	let text;
	try {
		text = readFileSync(name, "utf8");
	} catch (error) {
		throw wrong(`cannot be read (${error.code}); expected a description of the tiles`);
	}
	try {
		return JSON.parse(text);
	} catch {
		throw wrong("expected a JSON object, got no JSON");
	}
}
async function openTile({ folder, set, extension, fromSouth }, z, x, y) {
	const across = 2 ** z;
	if (z < set.minzoom || z > set.maxzoom || x >= across || y >= across) return "refused";
	const row = fromSouth ? across - 1 - y : y;
	const opened = await openInside(folder, join(String(z), String(x), `${row}.${extension}`));
	if (typeof opened === "string") return opened;
	if (opened.size <= 4194304) return {
		...opened,
		type: types.get(extension) ?? ""
	};
	await opened.file.close();
	return "refused";
}
// codec/log.ts
var maxData = 16777216;
new TextDecoder("latin1");
// codec/packet.ts
var smallMagic = 1279471666;
var fragmentMagic = 1279471667;
var smallHeader = 8;
var fragmentHeader = 20;
var smallPayload = 65499;
var fragmentPayload = 65487;
var ascii = new TextDecoder("latin1");
function readChannel(bytes, at) {
	const end = bytes.subarray(at, at + 63 + 1).indexOf(0);
	if (end < 0) return `no channel of at most 63 bytes with a NUL after it`;
	if (end === 0) return "a channel without a name";
	return {
		channel: ascii.decode(bytes.subarray(at, at + end)),
		end: at + end
	};
}
function parseSmall(bytes, view) {
	const name = readChannel(bytes, smallHeader);
	if (typeof name === "string") return name;
	return {
		kind: "small",
		sequence: view.getUint32(4),
		channel: name.channel,
		payload: bytes.subarray(name.end + 1)
	};
}
function parseFragment(bytes, view) {
	if (bytes.length < fragmentHeader) return `a fragment of ${bytes.length} bytes has no header`;
	const total = view.getUint32(8);
	const offset = view.getUint32(12);
	const number = view.getUint16(16);
	const count = view.getUint16(18);
	if (total > 16777216) return `a message of ${total} bytes, at most ${maxData} are taken`;
	if (number >= count) return `fragment ${number} of ${count}`;
	const name = number === 0 ? readChannel(bytes, fragmentHeader) : {
		channel: "",
		end: 19
	};
	if (typeof name === "string") return name;
	const data = bytes.subarray(name.end + 1);
	if (data.length === 0) return `fragment ${number} of ${count} is empty`;
	if (offset + data.length > total) return `fragment ${number} ends at byte ${offset + data.length} of a message of ${total}`;
	return {
		kind: "fragment",
		sequence: view.getUint32(4),
		total,
		offset,
		number,
		count,
		channel: name.channel,
		data
	};
}
function parsePacket(bytes) {
	if (bytes.length < smallHeader) return `${bytes.length} bytes are no LCM packet`;
	const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
	const magic = view.getUint32(0);
	if (magic === smallMagic) return parseSmall(bytes, view);
	if (magic === fragmentMagic) return parseFragment(bytes, view);
	return `${magic.toString(16).padStart(8, "0")} begins no LCM packet`;
}
function head(size, magic, sequence) {
	const bytes = new Uint8Array(size);
	const view = new DataView(bytes.buffer);
	view.setUint32(0, magic);
	view.setUint32(4, sequence);
	return {
		bytes,
		view
	};
}
function packets(channel, payload, sequence, perFragment = fragmentPayload) {
	const name = new TextEncoder().encode(channel);
	if (name.length < 1 || name.length > 63 || name.includes(0)) throw new Error(`a channel has 1 to 63 bytes, not "${channel}"`);
	if (perFragment === fragmentPayload && name.length + 1 + payload.length <= smallPayload) {
		const { bytes } = head(smallHeader + name.length + 1 + payload.length, smallMagic, sequence);
		bytes.set(name, smallHeader);
		bytes.set(payload, smallHeader + name.length + 1);
		return [bytes];
	}
	return fragments(name, payload, sequence, perFragment);
}
function fragments(name, payload, sequence, perFragment) {
	const first = perFragment - name.length - 1;
	if (first < 1) throw new Error(`fragments of ${perFragment} bytes have no room for the channel`);
	const count = 1 + Math.max(0, Math.ceil((payload.length - first) / perFragment));
	if (count > 65535) throw new Error(`${count} fragments, at most 65535 can be numbered`);
	return Array.from({ length: count }, (_, number) => {
		const offset = number === 0 ? 0 : first + (number - 1) * perFragment;
		const data = payload.subarray(offset, number === 0 ? first : offset + perFragment);
		const extra = number === 0 ? name.length + 1 : 0;
		const { bytes, view } = head(fragmentHeader + extra + data.length, fragmentMagic, sequence);
		view.setUint32(8, payload.length);
		view.setUint32(12, offset);
		view.setUint16(16, number);
		view.setUint16(18, count);
		if (number === 0) bytes.set(name, fragmentHeader);
		bytes.set(data, fragmentHeader + extra);
		return bytes;
	});
}
// codec/reassembly.ts
var defaults = {
	unfinished: 64,
	bytes: 33554432,
	senders: 64
};
var largestGap = 65536;
var Reassembly = class {
	lost = 0;
	unfinished = /* @__PURE__ */ new Map();
	finished = /* @__PURE__ */ new Map();
	latest = /* @__PURE__ */ new Map();
	bytes = 0;
	limits;
	constructor(limits = {}) {
		this.limits = {
			...defaults,
			...limits
		};
	}
	accept(sender, bytes) {
		const packet = parsePacket(bytes);
		if (typeof packet === "string") return packet;
		this.count(sender, packet.sequence);
		if (packet.kind === "small") return {
			channel: packet.channel,
			payload: packet.payload
		};
		return this.add(`${sender} ${packet.sequence}`, packet);
	}
	count(sender, sequence) {
		const before = this.latest.get(sender);
		const step = before === void 0 ? 1 : sequence - before >>> 0;
		if (step === 0) return;
		if (step > 4294901759) return;
		if (step <= largestGap) this.lost += step - 1;
		this.latest.delete(sender);
		this.latest.set(sender, sequence);
		if (this.latest.size > this.limits.senders) this.latest.delete(oldest(this.latest));
	}
	add(key, fragment) {
		if (this.finished.has(key)) return null;
		const message = this.unfinished.get(key) ?? this.begin(key, fragment);
		if (message.total !== fragment.total || message.count !== fragment.count) {
			this.forget(key);
			return `fragments disagree: ${message.count} of ${message.total} bytes, ${fragment.count} of ${fragment.total}`;
		}
		if (message.parts.has(fragment.number)) return null;
		message.parts.set(fragment.number, fragment);
		message.size += fragment.data.length;
		this.bytes += fragment.data.length;
		if (message.parts.size === message.count) {
			this.forget(key);
			this.remember(key);
			return assemble(message);
		}
		this.makeRoom();
		return null;
	}
	begin(key, { total, count }) {
		const message = {
			total,
			count,
			parts: /* @__PURE__ */ new Map(),
			size: 0
		};
		this.unfinished.set(key, message);
		return message;
	}
	forget(key) {
		this.bytes -= this.unfinished.get(key)?.size ?? 0;
		this.unfinished.delete(key);
	}
	remember(key) {
		this.finished.set(key, true);
		if (this.finished.size > this.limits.unfinished) this.finished.delete(oldest(this.finished));
	}
	makeRoom() {
		while (this.unfinished.size > this.limits.unfinished || this.bytes > this.limits.bytes) {
			this.forget(oldest(this.unfinished));
			this.lost += 1;
		}
	}
};
var oldest = (map) => map.keys().next().value ?? "";
function assemble({ total, count, parts }) {
	const payload = new Uint8Array(total);
	let at = 0;
	for (let number = 0; number < count; number += 1) {
		const part = parts.get(number);
		if (!part || part.offset !== at) return `fragment ${number} begins at byte ${part?.offset}, not ${at}`;
		payload.set(part.data, at);
		at += part.data.length;
	}
	if (at !== total) return `${count} fragments hold ${at} of ${total} bytes`;
	return {
		channel: parts.get(0)?.channel ?? "",
		payload
	};
}
// bridge/udp.ts
var loopback = "127.0.0.1";
var LcmSocket = class {
	stats = {
		messages: 0,
		bytes: 0,
		lost: 0
	};
	group;
	journal;
	receiver;
	sender;
	reassembly = new Reassembly();
	ownAddresses = new OwnAddresses();
	sequence = 0;
	peer = null;
	constructor(group, journal, onMessage) {
		this.group = group;
		this.journal = journal;
		this.receiver = createSocket({
			type: "udp4",
			reuseAddr: group.multicast,
			recvBufferSize: group.receiveBuffer
		});
		this.sender = createSocket({ type: "udp4" });
		this.receiver.on("message", (packet, { address, port }) => {
			if (!this.isOurs(address)) return;
			const whole = this.reassembly.accept(`${address}:${port}`, packet);
			this.stats.lost = this.reassembly.lost;
			if (typeof whole === "string") journal.refused("packet", `a packet of ${address}:${port}: ${whole}`);
			else if (whole) {
				this.stats.messages += 1;
				this.stats.bytes += whole.payload.length;
				if (!group.multicast) this.peer = {
					address,
					port
				};
				onMessage(whole.channel, whole.payload);
			}
		});
	}
	async open() {
		const { group, receiver, sender } = this;
		await bound(sender, 0, group.network ? "0.0.0.0" : loopback);
		if (group.multicast) {
			if (!group.network) sender.setMulticastInterface(loopback);
			sender.setMulticastTTL(group.ttl);
			sender.setMulticastLoopback(true);
		}
		await bound(receiver, group.port, group.host);
		if (group.multicast) receiver.addMembership(group.host, group.network ? void 0 : loopback);
		for (const socket of [receiver, sender]) socket.on("error", (error) => this.journal.refused("packet", `UDP: ${error.message}`));
	}
	publish(channel, payload) {
		const { group } = this;
		const to = group.multicast ? {
			address: group.host,
			port: group.port
		} : this.peer;
		if (!to) return false;
		for (const packet of packets(channel, payload, this.sequence)) this.sender.send(packet, to.port, to.address);
		this.sequence = this.sequence + 1 >>> 0;
		return true;
	}
	close() {
		this.receiver.close();
		this.sender.close();
	}
	isOurs(address) {
		if (this.group.network || this.ownAddresses.has(address)) return true;
		this.journal.refused("packet", `a packet of another host, ${address}; --allow-network takes them`);
		return false;
	}
};
function bound(socket, port, address) {
	return new Promise((resolve, reject) => {
		socket.once("error", reject);
		socket.bind({
			port,
			address,
			exclusive: false
		}, () => {
			socket.off("error", reject);
			resolve();
		});
	});
}
var OwnAddresses = class {
	known = /* @__PURE__ */ new Set();
	readMs = Number.NEGATIVE_INFINITY;
	has(address) {
		if (address.startsWith("127.") || address === "0.0.0.0" || this.known.has(address)) return true;
		const now = performance.now();
		if (now - this.readMs < 1e3) return false;
		this.readMs = now;
		this.known = new Set(Object.values(networkInterfaces()).flatMap((all) => (all ?? []).map((one) => one.address)));
		return this.known.has(address);
	}
};
// node_modules/ws/lib/constants.js
var require_constants = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var BINARY_TYPES = [
		"nodebuffer",
		"arraybuffer",
		"fragments"
	];
	var hasBlob = typeof Blob !== "undefined";
	if (hasBlob) BINARY_TYPES.push("blob");
	module.exports = {
		BINARY_TYPES,
		CLOSE_TIMEOUT: 3e4,
		EMPTY_BUFFER: Buffer.alloc(0),
		GUID: "258EAFA5-E914-47DA-95CA-C5AB0DC85B11",
		hasBlob,
		kForOnEventAttribute: Symbol("kIsForOnEventAttribute"),
		kListener: Symbol("kListener"),
		kStatusCode: Symbol("status-code"),
		kWebSocket: Symbol("websocket"),
		NOOP: () => {}
	};
}));
// node_modules/ws/lib/buffer-util.js
var require_buffer_util = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { websocketMask, websocketUnmask } = __require("http");
	var { EMPTY_BUFFER } = require_constants();
	var FastBuffer = Buffer[Symbol.species];
	/**
	* Merges an array of buffers into a new buffer.
	*
	* @param {Buffer[]} list The array of buffers to concat
	* @param {Number} totalLength The total length of buffers in the list
	* @return {Buffer} The resulting buffer
	* @public
	*/
	function concat(list, totalLength) {
		if (list.length === 0) return EMPTY_BUFFER;
		if (list.length === 1) return list[0];
		const target = Buffer.allocUnsafe(totalLength);
		let offset = 0;
		for (let i = 0; i < list.length; i++) {
			const buf = list[i];
			target.set(buf, offset);
			offset += buf.length;
		}
		if (offset < totalLength) return new FastBuffer(target.buffer, target.byteOffset, offset);
		return target;
	}
	/**
	* Masks a buffer using the given mask.
	*
	* @param {Buffer} source The buffer to mask
	* @param {Buffer} mask The mask to use
	* @param {Buffer} output The buffer where to store the result
	* @param {Number} offset The offset at which to start writing
	* @param {Number} length The number of bytes to mask.
	* @public
	*/
	function _mask(source, mask, output, offset, length) {
		for (let i = 0; i < length; i++) output[offset + i] = source[i] ^ mask[i & 3];
	}
	/**
	* Unmasks a buffer using the given mask.
	*
	* @param {Buffer} buffer The buffer to unmask
	* @param {Buffer} mask The mask to use
	* @public
	*/
	function _unmask(buffer, mask) {
		for (let i = 0; i < buffer.length; i++) buffer[i] ^= mask[i & 3];
	}
	/**
	* Converts a buffer to an `ArrayBuffer`.
	*
	* @param {Buffer} buf The buffer to convert
	* @return {ArrayBuffer} Converted buffer
	* @public
	*/
	function toArrayBuffer(buf) {
		if (buf.length === buf.buffer.byteLength) return buf.buffer;
		return buf.buffer.slice(buf.byteOffset, buf.byteOffset + buf.length);
	}
	/**
	* Converts `data` to a `Buffer`.
	*
	* @param {*} data The data to convert
	* @return {Buffer} The buffer
	* @throws {TypeError}
	* @public
	*/
	function toBuffer(data) {
		toBuffer.readOnly = true;
		if (Buffer.isBuffer(data)) return data;
		let buf;
		if (data instanceof ArrayBuffer) buf = new FastBuffer(data);
		else if (ArrayBuffer.isView(data)) buf = new FastBuffer(data.buffer, data.byteOffset, data.byteLength);
		else {
			buf = Buffer.from(data);
			toBuffer.readOnly = false;
		}
		return buf;
	}
	module.exports = {
		concat,
		mask: _mask,
		toArrayBuffer,
		toBuffer,
		unmask: _unmask
	};
	if (websocketMask) {
		module.exports.mask = function(source, mask, output, offset, length) {
			if (length < 24) _mask(source, mask, output, offset, length);
			else websocketMask(source, mask, output, offset, length);
		};
		module.exports.unmask = function(buffer, mask) {
			if (buffer.length < 24) _unmask(buffer, mask);
			else websocketUnmask(buffer, mask);
		};
	}
}));
// node_modules/ws/lib/limiter.js
var require_limiter = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var kDone = Symbol("kDone");
	var kRun = Symbol("kRun");
	/**
	* A very simple job queue with adjustable concurrency. Adapted from
	* https://github.com/STRML/async-limiter
	*/
	var Limiter = class {
		/**
		* Creates a new `Limiter`.
		*
		* @param {Number} [concurrency=Infinity] The maximum number of jobs allowed
		*     to run concurrently
		*/
		constructor(concurrency) {
			this[kDone] = () => {
				this.pending--;
				this[kRun]();
			};
			this.concurrency = concurrency || Infinity;
			this.jobs = [];
			this.pending = 0;
		}
		/**
		* Adds a job to the queue.
		*
		* @param {Function} job The job to run
		* @public
		*/
		add(job) {
			this.jobs.push(job);
			this[kRun]();
		}
		/**
		* Removes a job from the queue and runs it if possible.
		*
		* @private
		*/
		[kRun]() {
			if (this.pending === this.concurrency) return;
			if (this.jobs.length) {
				const job = this.jobs.shift();
				this.pending++;
				job(this[kDone]);
			}
		}
	};
	module.exports = Limiter;
}));
// node_modules/ws/lib/permessage-deflate.js
var require_permessage_deflate = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var zlib = __require("zlib");
	var bufferUtil = require_buffer_util();
	var Limiter = require_limiter();
	var { kStatusCode } = require_constants();
	var FastBuffer = Buffer[Symbol.species];
	var TRAILER = Buffer.from([
		0,
		0,
		255,
		255
	]);
	var kPerMessageDeflate = Symbol("permessage-deflate");
	var kTotalLength = Symbol("total-length");
	var kCallback = Symbol("callback");
	var kBuffers = Symbol("buffers");
	var kError = Symbol("error");
	var zlibLimiter;
	/**
	* permessage-deflate implementation.
	*/
	var PerMessageDeflate = class {
		/**
		* Creates a PerMessageDeflate instance.
		*
		* @param {Object} [options] Configuration options
		* @param {(Boolean|Number)} [options.clientMaxWindowBits] Advertise support
		*     for, or request, a custom client window size
		* @param {Boolean} [options.clientNoContextTakeover=false] Advertise/
		*     acknowledge disabling of client context takeover
		* @param {Number} [options.concurrencyLimit=10] The number of concurrent
		*     calls to zlib
		* @param {Boolean} [options.isServer=false] Create the instance in either
		*     server or client mode
		* @param {Number} [options.maxPayload=0] The maximum allowed message length
		* @param {(Boolean|Number)} [options.serverMaxWindowBits] Request/confirm the
		*     use of a custom server window size
		* @param {Boolean} [options.serverNoContextTakeover=false] Request/accept
		*     disabling of server context takeover
		* @param {Number} [options.threshold=1024] Size (in bytes) below which
		*     messages should not be compressed if context takeover is disabled
		* @param {Object} [options.zlibDeflateOptions] Options to pass to zlib on
		*     deflate
		* @param {Object} [options.zlibInflateOptions] Options to pass to zlib on
		*     inflate
		*/
		constructor(options) {
			this._options = options || {};
			this._threshold = this._options.threshold !== void 0 ? this._options.threshold : 1024;
			this._maxPayload = this._options.maxPayload | 0;
			this._isServer = !!this._options.isServer;
			this._deflate = null;
			this._inflate = null;
			this.params = null;
			if (!zlibLimiter) zlibLimiter = new Limiter(this._options.concurrencyLimit !== void 0 ? this._options.concurrencyLimit : 10);
		}
		/**
		* @type {String}
		*/
		static get extensionName() {
			return "permessage-deflate";
		}
		/**
		* Create an extension negotiation offer.
		*
		* @return {Object} Extension parameters
		* @public
		*/
		offer() {
			const params = {};
			if (this._options.serverNoContextTakeover) params.server_no_context_takeover = true;
			if (this._options.clientNoContextTakeover) params.client_no_context_takeover = true;
			if (this._options.serverMaxWindowBits) params.server_max_window_bits = this._options.serverMaxWindowBits;
			if (this._options.clientMaxWindowBits) params.client_max_window_bits = this._options.clientMaxWindowBits;
			else if (this._options.clientMaxWindowBits == null) params.client_max_window_bits = true;
			return params;
		}
		/**
		* Accept an extension negotiation offer/response.
		*
		* @param {Array} configurations The extension negotiation offers/reponse
		* @return {Object} Accepted configuration
		* @public
		*/
		accept(configurations) {
			configurations = this.normalizeParams(configurations);
			this.params = this._isServer ? this.acceptAsServer(configurations) : this.acceptAsClient(configurations);
			return this.params;
		}
		/**
		* Releases all resources used by the extension.
		*
		* @public
		*/
		cleanup() {
			if (this._inflate) {
				this._inflate.close();
				this._inflate = null;
			}
			if (this._deflate) {
				const callback = this._deflate[kCallback];
				this._deflate.close();
				this._deflate = null;
				if (callback) callback(/* @__PURE__ */ new Error("The deflate stream was closed while data was being processed"));
			}
		}
		/**
		*  Accept an extension negotiation offer.
		*
		* @param {Array} offers The extension negotiation offers
		* @return {Object} Accepted configuration
		* @private
		*/
		acceptAsServer(offers) {
			const opts = this._options;
			const accepted = offers.find((params) => {
				if (opts.serverNoContextTakeover === false && params.server_no_context_takeover || params.server_max_window_bits && (opts.serverMaxWindowBits === false || typeof opts.serverMaxWindowBits === "number" && opts.serverMaxWindowBits > params.server_max_window_bits) || typeof opts.clientMaxWindowBits === "number" && (typeof params.client_max_window_bits === "number" ? opts.clientMaxWindowBits > params.client_max_window_bits : !params.client_max_window_bits)) return false;
				return true;
			});
			if (!accepted) throw new Error("None of the extension offers can be accepted");
			if (opts.serverNoContextTakeover) accepted.server_no_context_takeover = true;
			if (opts.clientNoContextTakeover) accepted.client_no_context_takeover = true;
			if (typeof opts.serverMaxWindowBits === "number") accepted.server_max_window_bits = opts.serverMaxWindowBits;
			if (typeof opts.clientMaxWindowBits === "number") accepted.client_max_window_bits = opts.clientMaxWindowBits;
			else if (accepted.client_max_window_bits === true || opts.clientMaxWindowBits === false) delete accepted.client_max_window_bits;
			return accepted;
		}
		/**
		* Accept the extension negotiation response.
		*
		* @param {Array} response The extension negotiation response
		* @return {Object} Accepted configuration
		* @private
		*/
		acceptAsClient(response) {
			const params = response[0];
			if (this._options.clientNoContextTakeover === false && params.client_no_context_takeover) throw new Error("Unexpected parameter \"client_no_context_takeover\"");
			if (!params.client_max_window_bits) {
				if (typeof this._options.clientMaxWindowBits === "number") params.client_max_window_bits = this._options.clientMaxWindowBits;
			} else if (this._options.clientMaxWindowBits === false || typeof this._options.clientMaxWindowBits === "number" && params.client_max_window_bits > this._options.clientMaxWindowBits) throw new Error("Unexpected or invalid parameter \"client_max_window_bits\"");
			return params;
		}
		/**
		* Normalize parameters.
		*
		* @param {Array} configurations The extension negotiation offers/reponse
		* @return {Array} The offers/response with normalized parameters
		* @private
		*/
		normalizeParams(configurations) {
			configurations.forEach((params) => {
				Object.keys(params).forEach((key) => {
					let value = params[key];
					if (value.length > 1) throw new Error(`Parameter "${key}" must have only a single value`);
					value = value[0];
					if (key === "client_max_window_bits") {
						if (value !== true) {
							const num = +value;
							if (!Number.isInteger(num) || num < 8 || num > 15) throw new TypeError(`Invalid value for parameter "${key}": ${value}`);
							value = num;
						} else if (!this._isServer) throw new TypeError(`Invalid value for parameter "${key}": ${value}`);
					} else if (key === "server_max_window_bits") {
						const num = +value;
						if (!Number.isInteger(num) || num < 8 || num > 15) throw new TypeError(`Invalid value for parameter "${key}": ${value}`);
						value = num;
					} else if (key === "client_no_context_takeover" || key === "server_no_context_takeover") {
						if (value !== true) throw new TypeError(`Invalid value for parameter "${key}": ${value}`);
					} else throw new Error(`Unknown parameter "${key}"`);
					params[key] = value;
				});
			});
			return configurations;
		}
		/**
		* Decompress data. Concurrency limited.
		*
		* @param {Buffer} data Compressed data
		* @param {Boolean} fin Specifies whether or not this is the last fragment
		* @param {Function} callback Callback
		* @public
		*/
		decompress(data, fin, callback) {
			zlibLimiter.add((done) => {
				this._decompress(data, fin, (err, result) => {
					done();
					callback(err, result);
				});
			});
		}
		/**
		* Compress data. Concurrency limited.
		*
		* @param {(Buffer|String)} data Data to compress
		* @param {Boolean} fin Specifies whether or not this is the last fragment
		* @param {Function} callback Callback
		* @public
		*/
		compress(data, fin, callback) {
			zlibLimiter.add((done) => {
				this._compress(data, fin, (err, result) => {
					done();
					callback(err, result);
				});
			});
		}
		/**
		* Decompress data.
		*
		* @param {Buffer} data Compressed data
		* @param {Boolean} fin Specifies whether or not this is the last fragment
		* @param {Function} callback Callback
		* @private
		*/
		_decompress(data, fin, callback) {
			const endpoint = this._isServer ? "client" : "server";
			if (!this._inflate) {
				const key = `${endpoint}_max_window_bits`;
				const windowBits = typeof this.params[key] !== "number" ? zlib.Z_DEFAULT_WINDOWBITS : this.params[key];
				this._inflate = zlib.createInflateRaw({
					...this._options.zlibInflateOptions,
					windowBits
				});
				this._inflate[kPerMessageDeflate] = this;
				this._inflate[kTotalLength] = 0;
				this._inflate[kBuffers] = [];
				this._inflate.on("error", inflateOnError);
				this._inflate.on("data", inflateOnData);
			}
			this._inflate[kCallback] = callback;
			this._inflate.write(data);
			if (fin) this._inflate.write(TRAILER);
			this._inflate.flush(() => {
				const err = this._inflate[kError];
				if (err) {
					this._inflate.close();
					this._inflate = null;
					callback(err);
					return;
				}
				const data = bufferUtil.concat(this._inflate[kBuffers], this._inflate[kTotalLength]);
				if (this._inflate._readableState.endEmitted) {
					this._inflate.close();
					this._inflate = null;
				} else {
					this._inflate[kTotalLength] = 0;
					this._inflate[kBuffers] = [];
					if (fin && this.params[`${endpoint}_no_context_takeover`]) this._inflate.reset();
				}
				callback(null, data);
			});
		}
		/**
		* Compress data.
		*
		* @param {(Buffer|String)} data Data to compress
		* @param {Boolean} fin Specifies whether or not this is the last fragment
		* @param {Function} callback Callback
		* @private
		*/
		_compress(data, fin, callback) {
			const endpoint = this._isServer ? "server" : "client";
			if (!this._deflate) {
				const key = `${endpoint}_max_window_bits`;
				const windowBits = typeof this.params[key] !== "number" ? zlib.Z_DEFAULT_WINDOWBITS : this.params[key];
				this._deflate = zlib.createDeflateRaw({
					...this._options.zlibDeflateOptions,
					windowBits
				});
				this._deflate[kTotalLength] = 0;
				this._deflate[kBuffers] = [];
				this._deflate.on("data", deflateOnData);
			}
			this._deflate[kCallback] = callback;
			this._deflate.write(data);
			this._deflate.flush(zlib.Z_SYNC_FLUSH, () => {
				if (!this._deflate) return;
				let data = bufferUtil.concat(this._deflate[kBuffers], this._deflate[kTotalLength]);
				if (fin) data = new FastBuffer(data.buffer, data.byteOffset, data.length - 4);
				this._deflate[kCallback] = null;
				this._deflate[kTotalLength] = 0;
				this._deflate[kBuffers] = [];
				if (fin && this.params[`${endpoint}_no_context_takeover`]) this._deflate.reset();
				callback(null, data);
			});
		}
	};
	module.exports = PerMessageDeflate;
	/**
	* The listener of the `zlib.DeflateRaw` stream `'data'` event.
	*
	* @param {Buffer} chunk A chunk of data
	* @private
	*/
	function deflateOnData(chunk) {
		this[kBuffers].push(chunk);
		this[kTotalLength] += chunk.length;
	}
	/**
	* The listener of the `zlib.InflateRaw` stream `'data'` event.
	*
	* @param {Buffer} chunk A chunk of data
	* @private
	*/
	function inflateOnData(chunk) {
		this[kTotalLength] += chunk.length;
		if (this[kPerMessageDeflate]._maxPayload < 1 || this[kTotalLength] <= this[kPerMessageDeflate]._maxPayload) {
			this[kBuffers].push(chunk);
			return;
		}
		this[kError] = /* @__PURE__ */ new RangeError("Max payload size exceeded");
		this[kError].code = "WS_ERR_UNSUPPORTED_MESSAGE_LENGTH";
		this[kError][kStatusCode] = 1009;
		this.removeListener("data", inflateOnData);
		this.reset();
	}
	/**
	* The listener of the `zlib.InflateRaw` stream `'error'` event.
	*
	* @param {Error} err The emitted error
	* @private
	*/
	function inflateOnError(err) {
		this[kPerMessageDeflate]._inflate = null;
		if (this[kError]) {
			this[kCallback](this[kError]);
			return;
		}
		err[kStatusCode] = 1007;
		this[kCallback](err);
	}
}));
// node_modules/ws/lib/validation.js
var require_validation = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { isUtf8 } = __require("buffer");
	var { hasBlob } = require_constants();
	var tokenChars = [
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		1,
		0,
		1,
		1,
		1,
		1,
		1,
		0,
		0,
		1,
		1,
		0,
		1,
		1,
		0,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		0,
		0,
		0,
		0,
		0,
		0,
		0,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		0,
		0,
		0,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		1,
		0,
		1,
		0,
		1,
		0
	];
	/**
	* Checks if a status code is allowed in a close frame.
	*
	* @param {Number} code The status code
	* @return {Boolean} `true` if the status code is valid, else `false`
	* @public
	*/
	function isValidStatusCode(code) {
		return code >= 1e3 && code <= 1014 && code !== 1004 && code !== 1005 && code !== 1006 || code >= 3e3 && code <= 4999;
	}
	/**
	* Checks if a given buffer contains only correct UTF-8.
	* Ported from https://www.cl.cam.ac.uk/%7Emgk25/ucs/utf8_check.c by
	* Markus Kuhn.
	*
	* @param {Buffer} buf The buffer to check
	* @return {Boolean} `true` if `buf` contains only correct UTF-8, else `false`
	* @public
	*/
	function _isValidUTF8(buf) {
		const len = buf.length;
		let i = 0;
		while (i < len) if ((buf[i] & 128) === 0) i++;
		else if ((buf[i] & 224) === 192) {
			if (i + 1 === len || (buf[i + 1] & 192) !== 128 || (buf[i] & 254) === 192) return false;
			i += 2;
		} else if ((buf[i] & 240) === 224) {
			if (i + 2 >= len || (buf[i + 1] & 192) !== 128 || (buf[i + 2] & 192) !== 128 || buf[i] === 224 && (buf[i + 1] & 224) === 128 || buf[i] === 237 && (buf[i + 1] & 224) === 160) return false;
			i += 3;
		} else if ((buf[i] & 248) === 240) {
			if (i + 3 >= len || (buf[i + 1] & 192) !== 128 || (buf[i + 2] & 192) !== 128 || (buf[i + 3] & 192) !== 128 || buf[i] === 240 && (buf[i + 1] & 240) === 128 || buf[i] === 244 && buf[i + 1] > 143 || buf[i] > 244) return false;
			i += 4;
		} else return false;
		return true;
	}
	/**
	* Determines whether a value is a `Blob`.
	*
	* @param {*} value The value to be tested
	* @return {Boolean} `true` if `value` is a `Blob`, else `false`
	* @private
	*/
	function isBlob(value) {
		return hasBlob && typeof value === "object" && typeof value.arrayBuffer === "function" && typeof value.type === "string" && typeof value.stream === "function" && (value[Symbol.toStringTag] === "Blob" || value[Symbol.toStringTag] === "File");
	}
	module.exports = {
		isBlob,
		isValidStatusCode,
		isValidUTF8: _isValidUTF8,
		tokenChars
	};
	if (isUtf8) module.exports.isValidUTF8 = function(buf) {
		return buf.length < 24 ? _isValidUTF8(buf) : isUtf8(buf);
	};
}));
// node_modules/ws/lib/receiver.js
var require_receiver = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { Writable } = __require("stream");
	var PerMessageDeflate = require_permessage_deflate();
	var { BINARY_TYPES, EMPTY_BUFFER, kStatusCode, kWebSocket } = require_constants();
	var { concat, toArrayBuffer, unmask } = require_buffer_util();
	var { isValidStatusCode, isValidUTF8 } = require_validation();
	var FastBuffer = Buffer[Symbol.species];
	var GET_INFO = 0;
	var GET_PAYLOAD_LENGTH_16 = 1;
	var GET_PAYLOAD_LENGTH_64 = 2;
	var GET_MASK = 3;
	var GET_DATA = 4;
	var INFLATING = 5;
	var DEFER_EVENT = 6;
	/**
	* HyBi Receiver implementation.
	*
	* @extends Writable
	*/
	var Receiver = class extends Writable {
		/**
		* Creates a Receiver instance.
		*
		* @param {Object} [options] Options object
		* @param {Boolean} [options.allowSynchronousEvents=true] Specifies whether
		*     any of the `'message'`, `'ping'`, and `'pong'` events can be emitted
		*     multiple times in the same tick
		* @param {String} [options.binaryType=nodebuffer] The type for binary data
		* @param {Object} [options.extensions] An object containing the negotiated
		*     extensions
		* @param {Boolean} [options.isServer=false] Specifies whether to operate in
		*     client or server mode
		* @param {Number} [options.maxBufferedChunks=0] The maximum number of
		*     buffered data chunks
		* @param {Number} [options.maxFragments=0] The maximum number of message
		*     fragments
		* @param {Number} [options.maxPayload=0] The maximum allowed message length
		* @param {Boolean} [options.skipUTF8Validation=false] Specifies whether or
		*     not to skip UTF-8 validation for text and close messages
		*/
		constructor(options = {}) {
			super();
			this._allowSynchronousEvents = options.allowSynchronousEvents !== void 0 ? options.allowSynchronousEvents : true;
			this._binaryType = options.binaryType || BINARY_TYPES[0];
			this._extensions = options.extensions || {};
			this._isServer = !!options.isServer;
			this._maxBufferedChunks = options.maxBufferedChunks | 0;
			this._maxFragments = options.maxFragments | 0;
			this._maxPayload = options.maxPayload | 0;
			this._skipUTF8Validation = !!options.skipUTF8Validation;
			this[kWebSocket] = void 0;
			this._bufferedBytes = 0;
			this._buffers = [];
			this._compressed = false;
			this._payloadLength = 0;
			this._mask = void 0;
			this._fragmented = 0;
			this._masked = false;
			this._fin = false;
			this._opcode = 0;
			this._totalPayloadLength = 0;
			this._messageLength = 0;
			this._numFragments = 0;
			this._fragments = [];
			this._errored = false;
			this._loop = false;
			this._state = GET_INFO;
		}
		/**
		* Implements `Writable.prototype._write()`.
		*
		* @param {Buffer} chunk The chunk of data to write
		* @param {String} encoding The character encoding of `chunk`
		* @param {Function} cb Callback
		* @private
		*/
		_write(chunk, encoding, cb) {
			if (this._opcode === 8 && this._state == GET_INFO) return cb();
			if (this._maxBufferedChunks > 0 && this._buffers.length >= this._maxBufferedChunks) {
				cb(this.createError(RangeError, "Too many buffered chunks", false, 1008, "WS_ERR_TOO_MANY_BUFFERED_PARTS"));
				return;
			}
			this._bufferedBytes += chunk.length;
			this._buffers.push(chunk);
			this.startLoop(cb);
		}
		/**
		* Consumes `n` bytes from the buffered data.
		*
		* @param {Number} n The number of bytes to consume
		* @return {Buffer} The consumed bytes
		* @private
		*/
		consume(n) {
			this._bufferedBytes -= n;
			if (n === this._buffers[0].length) return this._buffers.shift();
			if (n < this._buffers[0].length) {
				const buf = this._buffers[0];
				this._buffers[0] = new FastBuffer(buf.buffer, buf.byteOffset + n, buf.length - n);
				return new FastBuffer(buf.buffer, buf.byteOffset, n);
			}
			const dst = Buffer.allocUnsafe(n);
			do {
				const buf = this._buffers[0];
				const offset = dst.length - n;
				if (n >= buf.length) dst.set(this._buffers.shift(), offset);
				else {
					dst.set(new Uint8Array(buf.buffer, buf.byteOffset, n), offset);
					this._buffers[0] = new FastBuffer(buf.buffer, buf.byteOffset + n, buf.length - n);
				}
				n -= buf.length;
			} while (n > 0);
			return dst;
		}
		/**
		* Starts the parsing loop.
		*
		* @param {Function} cb Callback
		* @private
		*/
		startLoop(cb) {
			this._loop = true;
			do
				switch (this._state) {
					case GET_INFO:
						this.getInfo(cb);
						break;
					case GET_PAYLOAD_LENGTH_16:
						this.getPayloadLength16(cb);
						break;
					case GET_PAYLOAD_LENGTH_64:
						this.getPayloadLength64(cb);
						break;
					case GET_MASK:
						this.getMask();
						break;
					case GET_DATA:
						this.getData(cb);
						break;
					case INFLATING:
					case DEFER_EVENT:
						this._loop = false;
						return;
				}
			while (this._loop);
			if (!this._errored) cb();
		}
		/**
		* Reads the first two bytes of a frame.
		*
		* @param {Function} cb Callback
		* @private
		*/
		getInfo(cb) {
			if (this._bufferedBytes < 2) {
				this._loop = false;
				return;
			}
			const buf = this.consume(2);
			if ((buf[0] & 48) !== 0) {
				cb(this.createError(RangeError, "RSV2 and RSV3 must be clear", true, 1002, "WS_ERR_UNEXPECTED_RSV_2_3"));
				return;
			}
			const compressed = (buf[0] & 64) === 64;
			if (compressed && !this._extensions[PerMessageDeflate.extensionName]) {
				cb(this.createError(RangeError, "RSV1 must be clear", true, 1002, "WS_ERR_UNEXPECTED_RSV_1"));
				return;
			}
			this._fin = (buf[0] & 128) === 128;
			this._opcode = buf[0] & 15;
			this._payloadLength = buf[1] & 127;
			if (this._opcode === 0) {
				if (compressed) {
					cb(this.createError(RangeError, "RSV1 must be clear", true, 1002, "WS_ERR_UNEXPECTED_RSV_1"));
					return;
				}
				if (!this._fragmented) {
					cb(this.createError(RangeError, "invalid opcode 0", true, 1002, "WS_ERR_INVALID_OPCODE"));
					return;
				}
				this._opcode = this._fragmented;
			} else if (this._opcode === 1 || this._opcode === 2) {
				if (this._fragmented) {
					cb(this.createError(RangeError, `invalid opcode ${this._opcode}`, true, 1002, "WS_ERR_INVALID_OPCODE"));
					return;
				}
				this._compressed = compressed;
			} else if (this._opcode > 7 && this._opcode < 11) {
				if (!this._fin) {
					cb(this.createError(RangeError, "FIN must be set", true, 1002, "WS_ERR_EXPECTED_FIN"));
					return;
				}
				if (compressed) {
					cb(this.createError(RangeError, "RSV1 must be clear", true, 1002, "WS_ERR_UNEXPECTED_RSV_1"));
					return;
				}
				if (this._payloadLength > 125 || this._opcode === 8 && this._payloadLength === 1) {
					cb(this.createError(RangeError, `invalid payload length ${this._payloadLength}`, true, 1002, "WS_ERR_INVALID_CONTROL_PAYLOAD_LENGTH"));
					return;
				}
			} else {
				cb(this.createError(RangeError, `invalid opcode ${this._opcode}`, true, 1002, "WS_ERR_INVALID_OPCODE"));
				return;
			}
			if (!this._fin && !this._fragmented) this._fragmented = this._opcode;
			this._masked = (buf[1] & 128) === 128;
			if (this._isServer) {
				if (!this._masked) {
					cb(this.createError(RangeError, "MASK must be set", true, 1002, "WS_ERR_EXPECTED_MASK"));
					return;
				}
			} else if (this._masked) {
				cb(this.createError(RangeError, "MASK must be clear", true, 1002, "WS_ERR_UNEXPECTED_MASK"));
				return;
			}
			if (this._payloadLength === 126) this._state = GET_PAYLOAD_LENGTH_16;
			else if (this._payloadLength === 127) this._state = GET_PAYLOAD_LENGTH_64;
			else this.haveLength(cb);
		}
		/**
		* Gets extended payload length (7+16).
		*
		* @param {Function} cb Callback
		* @private
		*/
		getPayloadLength16(cb) {
			if (this._bufferedBytes < 2) {
				this._loop = false;
				return;
			}
			this._payloadLength = this.consume(2).readUInt16BE(0);
			this.haveLength(cb);
		}
		/**
		* Gets extended payload length (7+64).
		*
		* @param {Function} cb Callback
		* @private
		*/
		getPayloadLength64(cb) {
			if (this._bufferedBytes < 8) {
				this._loop = false;
				return;
			}
			const buf = this.consume(8);
			const num = buf.readUInt32BE(0);
			if (num > Math.pow(2, 21) - 1) {
				cb(this.createError(RangeError, "Unsupported WebSocket frame: payload length > 2^53 - 1", false, 1009, "WS_ERR_UNSUPPORTED_DATA_PAYLOAD_LENGTH"));
				return;
			}
			this._payloadLength = num * Math.pow(2, 32) + buf.readUInt32BE(4);
			this.haveLength(cb);
		}
		/**
		* Payload length has been read.
		*
		* @param {Function} cb Callback
		* @private
		*/
		haveLength(cb) {
			if (this._payloadLength && this._opcode < 8) {
				this._totalPayloadLength += this._payloadLength;
				if (this._totalPayloadLength > this._maxPayload && this._maxPayload > 0) {
					cb(this.createError(RangeError, "Max payload size exceeded", false, 1009, "WS_ERR_UNSUPPORTED_MESSAGE_LENGTH"));
					return;
				}
			}
			if (this._masked) this._state = GET_MASK;
			else this._state = GET_DATA;
		}
		/**
		* Reads mask bytes.
		*
		* @private
		*/
		getMask() {
			if (this._bufferedBytes < 4) {
				this._loop = false;
				return;
			}
			this._mask = this.consume(4);
			this._state = GET_DATA;
		}
		/**
		* Reads data bytes.
		*
		* @param {Function} cb Callback
		* @private
		*/
		getData(cb) {
			let data = EMPTY_BUFFER;
			if (this._payloadLength) {
				if (this._bufferedBytes < this._payloadLength) {
					this._loop = false;
					return;
				}
				data = this.consume(this._payloadLength);
				if (this._masked && (this._mask[0] | this._mask[1] | this._mask[2] | this._mask[3]) !== 0) unmask(data, this._mask);
			}
			this._mask = void 0;
			if (this._opcode > 7) {
				this.controlMessage(data, cb);
				return;
			}
			if (this._maxFragments > 0 && ++this._numFragments > this._maxFragments) {
				cb(this.createError(RangeError, "Too many message fragments", false, 1008, "WS_ERR_TOO_MANY_BUFFERED_PARTS"));
				return;
			}
			if (this._compressed) {
				this._state = INFLATING;
				this.decompress(data, cb);
				return;
			}
			if (data.length) {
				this._messageLength = this._totalPayloadLength;
				this._fragments.push(data);
			}
			this.dataMessage(cb);
		}
		/**
		* Decompresses data.
		*
		* @param {Buffer} data Compressed data
		* @param {Function} cb Callback
		* @private
		*/
		decompress(data, cb) {
			this._extensions[PerMessageDeflate.extensionName].decompress(data, this._fin, (err, buf) => {
				if (err) return cb(err);
				if (buf.length) {
					this._messageLength += buf.length;
					if (this._messageLength > this._maxPayload && this._maxPayload > 0) {
						cb(this.createError(RangeError, "Max payload size exceeded", false, 1009, "WS_ERR_UNSUPPORTED_MESSAGE_LENGTH"));
						return;
					}
					this._fragments.push(buf);
				}
				this.dataMessage(cb);
				if (this._state === GET_INFO) this.startLoop(cb);
			});
		}
		/**
		* Handles a data message.
		*
		* @param {Function} cb Callback
		* @private
		*/
		dataMessage(cb) {
			if (!this._fin) {
				this._state = GET_INFO;
				return;
			}
			const messageLength = this._messageLength;
			const fragments = this._fragments;
			this._totalPayloadLength = 0;
			this._messageLength = 0;
			this._fragmented = 0;
			this._numFragments = 0;
			this._fragments = [];
			if (this._opcode === 2) {
				let data;
				if (this._binaryType === "nodebuffer") data = concat(fragments, messageLength);
				else if (this._binaryType === "arraybuffer") data = toArrayBuffer(concat(fragments, messageLength));
				else if (this._binaryType === "blob") data = new Blob(fragments);
				else data = fragments;
				if (this._allowSynchronousEvents) {
					this.emit("message", data, true);
					this._state = GET_INFO;
				} else {
					this._state = DEFER_EVENT;
					setImmediate(() => {
						this.emit("message", data, true);
						this._state = GET_INFO;
						this.startLoop(cb);
					});
				}
			} else {
				const buf = concat(fragments, messageLength);
				if (!this._skipUTF8Validation && !isValidUTF8(buf)) {
					cb(this.createError(Error, "invalid UTF-8 sequence", true, 1007, "WS_ERR_INVALID_UTF8"));
					return;
				}
				if (this._state === INFLATING || this._allowSynchronousEvents) {
					this.emit("message", buf, false);
					this._state = GET_INFO;
				} else {
					this._state = DEFER_EVENT;
					setImmediate(() => {
						this.emit("message", buf, false);
						this._state = GET_INFO;
						this.startLoop(cb);
					});
				}
			}
		}
		/**
		* Handles a control message.
		*
		* @param {Buffer} data Data to handle
		* @return {(Error|RangeError|undefined)} A possible error
		* @private
		*/
		controlMessage(data, cb) {
			if (this._opcode === 8) {
				if (data.length === 0) {
					this._loop = false;
					this.emit("conclude", 1005, EMPTY_BUFFER);
					this.end();
				} else {
					const code = data.readUInt16BE(0);
					if (!isValidStatusCode(code)) {
						cb(this.createError(RangeError, `invalid status code ${code}`, true, 1002, "WS_ERR_INVALID_CLOSE_CODE"));
						return;
					}
					const buf = new FastBuffer(data.buffer, data.byteOffset + 2, data.length - 2);
					if (!this._skipUTF8Validation && !isValidUTF8(buf)) {
						cb(this.createError(Error, "invalid UTF-8 sequence", true, 1007, "WS_ERR_INVALID_UTF8"));
						return;
					}
					this._loop = false;
					this.emit("conclude", code, buf);
					this.end();
				}
				this._state = GET_INFO;
				return;
			}
			if (this._allowSynchronousEvents) {
				this.emit(this._opcode === 9 ? "ping" : "pong", data);
				this._state = GET_INFO;
			} else {
				this._state = DEFER_EVENT;
				setImmediate(() => {
					this.emit(this._opcode === 9 ? "ping" : "pong", data);
					this._state = GET_INFO;
					this.startLoop(cb);
				});
			}
		}
		/**
		* Builds an error object.
		*
		* @param {function(new:Error|RangeError)} ErrorCtor The error constructor
		* @param {String} message The error message
		* @param {Boolean} prefix Specifies whether or not to add a default prefix to
		*     `message`
		* @param {Number} statusCode The status code
		* @param {String} errorCode The exposed error code
		* @return {(Error|RangeError)} The error
		* @private
		*/
		createError(ErrorCtor, message, prefix, statusCode, errorCode) {
			this._loop = false;
			this._errored = true;
			const err = new ErrorCtor(prefix ? `Invalid WebSocket frame: ${message}` : message);
			Error.captureStackTrace(err, this.createError);
			err.code = errorCode;
			err[kStatusCode] = statusCode;
			return err;
		}
	};
	module.exports = Receiver;
}));
// node_modules/ws/lib/sender.js
var require_sender = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { Duplex } = __require("stream");
	var { randomFillSync } = __require("crypto");
	var { types: { isUint8Array } } = __require("util");
	var PerMessageDeflate = require_permessage_deflate();
	var { EMPTY_BUFFER, kWebSocket, NOOP } = require_constants();
	var { isBlob, isValidStatusCode } = require_validation();
	var { mask: applyMask, toBuffer } = require_buffer_util();
	var kByteLength = Symbol("kByteLength");
	var maskBuffer = Buffer.alloc(4);
	var RANDOM_POOL_SIZE = 8192;
	var randomPool;
	var randomPoolPointer = RANDOM_POOL_SIZE;
	var DEFAULT = 0;
	var DEFLATING = 1;
	var GET_BLOB_DATA = 2;
	module.exports = class Sender {
		/**
		* Creates a Sender instance.
		*
		* @param {Duplex} socket The connection socket
		* @param {Object} [extensions] An object containing the negotiated extensions
		* @param {Function} [generateMask] The function used to generate the masking
		*     key
		*/
		constructor(socket, extensions, generateMask) {
			this._extensions = extensions || {};
			if (generateMask) {
				this._generateMask = generateMask;
				this._maskBuffer = Buffer.alloc(4);
			}
			this._socket = socket;
			this._firstFragment = true;
			this._compress = false;
			this._bufferedBytes = 0;
			this._queue = [];
			this._state = DEFAULT;
			this.onerror = NOOP;
			this[kWebSocket] = void 0;
		}
		/**
		* Frames a piece of data according to the HyBi WebSocket protocol.
		*
		* @param {(Buffer|String)} data The data to frame
		* @param {Object} options Options object
		* @param {Boolean} [options.fin=false] Specifies whether or not to set the
		*     FIN bit
		* @param {Function} [options.generateMask] The function used to generate the
		*     masking key
		* @param {Boolean} [options.mask=false] Specifies whether or not to mask
		*     `data`
		* @param {Buffer} [options.maskBuffer] The buffer used to store the masking
		*     key
		* @param {Number} options.opcode The opcode
		* @param {Boolean} [options.readOnly=false] Specifies whether `data` can be
		*     modified
		* @param {Boolean} [options.rsv1=false] Specifies whether or not to set the
		*     RSV1 bit
		* @return {(Buffer|String)[]} The framed data
		* @public
		*/
		static frame(data, options) {
			let mask;
			let merge = false;
			let offset = 2;
			let skipMasking = false;
			if (options.mask) {
				mask = options.maskBuffer || maskBuffer;
				if (options.generateMask) options.generateMask(mask);
				else {
					if (randomPoolPointer === RANDOM_POOL_SIZE) {
						/* istanbul ignore else  */
						if (randomPool === void 0) randomPool = Buffer.alloc(RANDOM_POOL_SIZE);
						randomFillSync(randomPool, 0, RANDOM_POOL_SIZE);
						randomPoolPointer = 0;
					}
					mask[0] = randomPool[randomPoolPointer++];
					mask[1] = randomPool[randomPoolPointer++];
					mask[2] = randomPool[randomPoolPointer++];
					mask[3] = randomPool[randomPoolPointer++];
				}
				skipMasking = (mask[0] | mask[1] | mask[2] | mask[3]) === 0;
				offset = 6;
			}
			let dataLength;
			if (typeof data === "string") {
				if ((!options.mask || skipMasking) && options[kByteLength] !== void 0) dataLength = options[kByteLength];
				else {
					data = Buffer.from(data);
					dataLength = data.length;
				}
			} else {
				dataLength = data.length;
				merge = options.mask && options.readOnly && !skipMasking;
			}
			let payloadLength = dataLength;
			if (dataLength >= 65536) {
				offset += 8;
				payloadLength = 127;
			} else if (dataLength > 125) {
				offset += 2;
				payloadLength = 126;
			}
			const target = Buffer.allocUnsafe(merge ? dataLength + offset : offset);
			target[0] = options.fin ? options.opcode | 128 : options.opcode;
			if (options.rsv1) target[0] |= 64;
			target[1] = payloadLength;
			if (payloadLength === 126) target.writeUInt16BE(dataLength, 2);
			else if (payloadLength === 127) {
				target[2] = target[3] = 0;
				target.writeUIntBE(dataLength, 4, 6);
			}
			if (!options.mask) return dataLength ? [target, data] : [target];
			target[1] |= 128;
			target[offset - 4] = mask[0];
			target[offset - 3] = mask[1];
			target[offset - 2] = mask[2];
			target[offset - 1] = mask[3];
			if (!dataLength) return [target];
			if (skipMasking) return [target, data];
			if (merge) {
				applyMask(data, mask, target, offset, dataLength);
				return [target];
			}
			applyMask(data, mask, data, 0, dataLength);
			return [target, data];
		}
		/**
		* Sends a close message to the other peer.
		*
		* @param {Number} [code] The status code component of the body
		* @param {(String|Buffer)} [data] The message component of the body
		* @param {Boolean} [mask=false] Specifies whether or not to mask the message
		* @param {Function} [cb] Callback
		* @public
		*/
		close(code, data, mask, cb) {
			let buf;
			if (code === void 0) buf = EMPTY_BUFFER;
			else if (typeof code !== "number" || !isValidStatusCode(code)) throw new TypeError("First argument must be a valid error code number");
			else if (data === void 0 || !data.length) {
				buf = Buffer.allocUnsafe(2);
				buf.writeUInt16BE(code, 0);
			} else {
				const length = Buffer.byteLength(data);
				if (length > 123) throw new RangeError("The message must not be greater than 123 bytes");
				buf = Buffer.allocUnsafe(2 + length);
				buf.writeUInt16BE(code, 0);
				if (typeof data === "string") buf.write(data, 2);
				else if (isUint8Array(data)) buf.set(data, 2);
				else throw new TypeError("Second argument must be a string or a Uint8Array");
			}
			const options = {
				[kByteLength]: buf.length,
				fin: true,
				generateMask: this._generateMask,
				mask,
				maskBuffer: this._maskBuffer,
				opcode: 8,
				readOnly: false,
				rsv1: false
			};
			if (this._state !== DEFAULT) this.enqueue([
				this.dispatch,
				buf,
				false,
				options,
				cb
			]);
			else this.sendFrame(Sender.frame(buf, options), cb);
		}
		/**
		* Sends a ping message to the other peer.
		*
		* @param {*} data The message to send
		* @param {Boolean} [mask=false] Specifies whether or not to mask `data`
		* @param {Function} [cb] Callback
		* @public
		*/
		ping(data, mask, cb) {
			let byteLength;
			let readOnly;
			if (typeof data === "string") {
				byteLength = Buffer.byteLength(data);
				readOnly = false;
			} else if (isBlob(data)) {
				byteLength = data.size;
				readOnly = false;
			} else {
				data = toBuffer(data);
				byteLength = data.length;
				readOnly = toBuffer.readOnly;
			}
			if (byteLength > 125) throw new RangeError("The data size must not be greater than 125 bytes");
			const options = {
				[kByteLength]: byteLength,
				fin: true,
				generateMask: this._generateMask,
				mask,
				maskBuffer: this._maskBuffer,
				opcode: 9,
				readOnly,
				rsv1: false
			};
			if (isBlob(data)) {
				if (this._state !== DEFAULT) this.enqueue([
					this.getBlobData,
					data,
					false,
					options,
					cb
				]);
				else this.getBlobData(data, false, options, cb);
			} else if (this._state !== DEFAULT) this.enqueue([
				this.dispatch,
				data,
				false,
				options,
				cb
			]);
			else this.sendFrame(Sender.frame(data, options), cb);
		}
		/**
		* Sends a pong message to the other peer.
		*
		* @param {*} data The message to send
		* @param {Boolean} [mask=false] Specifies whether or not to mask `data`
		* @param {Function} [cb] Callback
		* @public
		*/
		pong(data, mask, cb) {
			let byteLength;
			let readOnly;
			if (typeof data === "string") {
				byteLength = Buffer.byteLength(data);
				readOnly = false;
			} else if (isBlob(data)) {
				byteLength = data.size;
				readOnly = false;
			} else {
				data = toBuffer(data);
				byteLength = data.length;
				readOnly = toBuffer.readOnly;
			}
			if (byteLength > 125) throw new RangeError("The data size must not be greater than 125 bytes");
			const options = {
				[kByteLength]: byteLength,
				fin: true,
				generateMask: this._generateMask,
				mask,
				maskBuffer: this._maskBuffer,
				opcode: 10,
				readOnly,
				rsv1: false
			};
			if (isBlob(data)) {
				if (this._state !== DEFAULT) this.enqueue([
					this.getBlobData,
					data,
					false,
					options,
					cb
				]);
				else this.getBlobData(data, false, options, cb);
			} else if (this._state !== DEFAULT) this.enqueue([
				this.dispatch,
				data,
				false,
				options,
				cb
			]);
			else this.sendFrame(Sender.frame(data, options), cb);
		}
		/**
		* Sends a data message to the other peer.
		*
		* @param {*} data The message to send
		* @param {Object} options Options object
		* @param {Boolean} [options.binary=false] Specifies whether `data` is binary
		*     or text
		* @param {Boolean} [options.compress=false] Specifies whether or not to
		*     compress `data`
		* @param {Boolean} [options.fin=false] Specifies whether the fragment is the
		*     last one
		* @param {Boolean} [options.mask=false] Specifies whether or not to mask
		*     `data`
		* @param {Function} [cb] Callback
		* @public
		*/
		send(data, options, cb) {
			const perMessageDeflate = this._extensions[PerMessageDeflate.extensionName];
			let opcode = options.binary ? 2 : 1;
			let rsv1 = options.compress;
			let byteLength;
			let readOnly;
			if (typeof data === "string") {
				byteLength = Buffer.byteLength(data);
				readOnly = false;
			} else if (isBlob(data)) {
				byteLength = data.size;
				readOnly = false;
			} else {
				data = toBuffer(data);
				byteLength = data.length;
				readOnly = toBuffer.readOnly;
			}
			if (this._firstFragment) {
				this._firstFragment = false;
				if (rsv1 && perMessageDeflate && perMessageDeflate.params[perMessageDeflate._isServer ? "server_no_context_takeover" : "client_no_context_takeover"]) rsv1 = byteLength >= perMessageDeflate._threshold;
				this._compress = rsv1;
			} else {
				rsv1 = false;
				opcode = 0;
			}
			if (options.fin) this._firstFragment = true;
			const opts = {
				[kByteLength]: byteLength,
				fin: options.fin,
				generateMask: this._generateMask,
				mask: options.mask,
				maskBuffer: this._maskBuffer,
				opcode,
				readOnly,
				rsv1
			};
			if (isBlob(data)) {
				if (this._state !== DEFAULT) this.enqueue([
					this.getBlobData,
					data,
					this._compress,
					opts,
					cb
				]);
				else this.getBlobData(data, this._compress, opts, cb);
			} else if (this._state !== DEFAULT) this.enqueue([
				this.dispatch,
				data,
				this._compress,
				opts,
				cb
			]);
			else this.dispatch(data, this._compress, opts, cb);
		}
		/**
		* Gets the contents of a blob as binary data.
		*
		* @param {Blob} blob The blob
		* @param {Boolean} [compress=false] Specifies whether or not to compress
		*     the data
		* @param {Object} options Options object
		* @param {Boolean} [options.fin=false] Specifies whether or not to set the
		*     FIN bit
		* @param {Function} [options.generateMask] The function used to generate the
		*     masking key
		* @param {Boolean} [options.mask=false] Specifies whether or not to mask
		*     `data`
		* @param {Buffer} [options.maskBuffer] The buffer used to store the masking
		*     key
		* @param {Number} options.opcode The opcode
		* @param {Boolean} [options.readOnly=false] Specifies whether `data` can be
		*     modified
		* @param {Boolean} [options.rsv1=false] Specifies whether or not to set the
		*     RSV1 bit
		* @param {Function} [cb] Callback
		* @private
		*/
		getBlobData(blob, compress, options, cb) {
			this._bufferedBytes += options[kByteLength];
			this._state = GET_BLOB_DATA;
			blob.arrayBuffer().then((arrayBuffer) => {
				if (this._socket.destroyed) {
					const err = /* @__PURE__ */ new Error("The socket was closed while the blob was being read");
					process.nextTick(callCallbacks, this, err, cb);
					return;
				}
				this._bufferedBytes -= options[kByteLength];
				const data = toBuffer(arrayBuffer);
				if (!compress) {
					this._state = DEFAULT;
					this.sendFrame(Sender.frame(data, options), cb);
					this.dequeue();
				} else this.dispatch(data, compress, options, cb);
			}).catch((err) => {
				process.nextTick(onError, this, err, cb);
			});
		}
		/**
		* Dispatches a message.
		*
		* @param {(Buffer|String)} data The message to send
		* @param {Boolean} [compress=false] Specifies whether or not to compress
		*     `data`
		* @param {Object} options Options object
		* @param {Boolean} [options.fin=false] Specifies whether or not to set the
		*     FIN bit
		* @param {Function} [options.generateMask] The function used to generate the
		*     masking key
		* @param {Boolean} [options.mask=false] Specifies whether or not to mask
		*     `data`
		* @param {Buffer} [options.maskBuffer] The buffer used to store the masking
		*     key
		* @param {Number} options.opcode The opcode
		* @param {Boolean} [options.readOnly=false] Specifies whether `data` can be
		*     modified
		* @param {Boolean} [options.rsv1=false] Specifies whether or not to set the
		*     RSV1 bit
		* @param {Function} [cb] Callback
		* @private
		*/
		dispatch(data, compress, options, cb) {
			if (!compress) {
				this.sendFrame(Sender.frame(data, options), cb);
				return;
			}
			const perMessageDeflate = this._extensions[PerMessageDeflate.extensionName];
			this._bufferedBytes += options[kByteLength];
			this._state = DEFLATING;
			perMessageDeflate.compress(data, options.fin, (_, buf) => {
				if (this._socket.destroyed) {
					const err = /* @__PURE__ */ new Error("The socket was closed while data was being compressed");
					callCallbacks(this, err, cb);
					return;
				}
				this._bufferedBytes -= options[kByteLength];
				this._state = DEFAULT;
				options.readOnly = false;
				this.sendFrame(Sender.frame(buf, options), cb);
				this.dequeue();
			});
		}
		/**
		* Executes queued send operations.
		*
		* @private
		*/
		dequeue() {
			while (this._state === DEFAULT && this._queue.length) {
				const params = this._queue.shift();
				this._bufferedBytes -= params[3][kByteLength];
				Reflect.apply(params[0], this, params.slice(1));
			}
		}
		/**
		* Enqueues a send operation.
		*
		* @param {Array} params Send operation parameters.
		* @private
		*/
		enqueue(params) {
			this._bufferedBytes += params[3][kByteLength];
			this._queue.push(params);
		}
		/**
		* Sends a frame.
		*
		* @param {(Buffer | String)[]} list The frame to send
		* @param {Function} [cb] Callback
		* @private
		*/
		sendFrame(list, cb) {
			if (list.length === 2) {
				this._socket.cork();
				this._socket.write(list[0]);
				this._socket.write(list[1], cb);
				this._socket.uncork();
			} else this._socket.write(list[0], cb);
		}
	};
	/**
	* Calls queued callbacks with an error.
	*
	* @param {Sender} sender The `Sender` instance
	* @param {Error} err The error to call the callbacks with
	* @param {Function} [cb] The first callback
	* @private
	*/
	function callCallbacks(sender, err, cb) {
		if (typeof cb === "function") cb(err);
		for (let i = 0; i < sender._queue.length; i++) {
			const params = sender._queue[i];
			const callback = params[params.length - 1];
			if (typeof callback === "function") callback(err);
		}
	}
	/**
	* Handles a `Sender` error.
	*
	* @param {Sender} sender The `Sender` instance
	* @param {Error} err The error
	* @param {Function} [cb] The first pending callback
	* @private
	*/
	function onError(sender, err, cb) {
		callCallbacks(sender, err, cb);
		sender.onerror(err);
	}
}));
// node_modules/ws/lib/event-target.js
var require_event_target = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { kForOnEventAttribute, kListener } = require_constants();
	var kCode = Symbol("kCode");
	var kData = Symbol("kData");
	var kError = Symbol("kError");
	var kMessage = Symbol("kMessage");
	var kReason = Symbol("kReason");
	var kTarget = Symbol("kTarget");
	var kType = Symbol("kType");
	var kWasClean = Symbol("kWasClean");
	/**
	* Class representing an event.
	*/
	var Event = class {
		/**
		* Create a new `Event`.
		*
		* @param {String} type The name of the event
		* @throws {TypeError} If the `type` argument is not specified
		*/
		constructor(type) {
			this[kTarget] = null;
			this[kType] = type;
		}
		/**
		* @type {*}
		*/
		get target() {
			return this[kTarget];
		}
		/**
		* @type {String}
		*/
		get type() {
			return this[kType];
		}
	};
	Object.defineProperty(Event.prototype, "target", { enumerable: true });
	Object.defineProperty(Event.prototype, "type", { enumerable: true });
	/**
	* Class representing a close event.
	*
	* @extends Event
	*/
	var CloseEvent = class extends Event {
		/**
		* Create a new `CloseEvent`.
		*
		* @param {String} type The name of the event
		* @param {Object} [options] A dictionary object that allows for setting
		*     attributes via object members of the same name
		* @param {Number} [options.code=0] The status code explaining why the
		*     connection was closed
		* @param {String} [options.reason=''] A human-readable string explaining why
		*     the connection was closed
		* @param {Boolean} [options.wasClean=false] Indicates whether or not the
		*     connection was cleanly closed
		*/
		constructor(type, options = {}) {
			super(type);
			this[kCode] = options.code === void 0 ? 0 : options.code;
			this[kReason] = options.reason === void 0 ? "" : options.reason;
			this[kWasClean] = options.wasClean === void 0 ? false : options.wasClean;
		}
		/**
		* @type {Number}
		*/
		get code() {
			return this[kCode];
		}
		/**
		* @type {String}
		*/
		get reason() {
			return this[kReason];
		}
		/**
		* @type {Boolean}
		*/
		get wasClean() {
			return this[kWasClean];
		}
	};
	Object.defineProperty(CloseEvent.prototype, "code", { enumerable: true });
	Object.defineProperty(CloseEvent.prototype, "reason", { enumerable: true });
	Object.defineProperty(CloseEvent.prototype, "wasClean", { enumerable: true });
	/**
	* Class representing an error event.
	*
	* @extends Event
	*/
	var ErrorEvent = class extends Event {
		/**
		* Create a new `ErrorEvent`.
		*
		* @param {String} type The name of the event
		* @param {Object} [options] A dictionary object that allows for setting
		*     attributes via object members of the same name
		* @param {*} [options.error=null] The error that generated this event
		* @param {String} [options.message=''] The error message
		*/
		constructor(type, options = {}) {
			super(type);
			this[kError] = options.error === void 0 ? null : options.error;
			this[kMessage] = options.message === void 0 ? "" : options.message;
		}
		/**
		* @type {*}
		*/
		get error() {
			return this[kError];
		}
		/**
		* @type {String}
		*/
		get message() {
			return this[kMessage];
		}
	};
	Object.defineProperty(ErrorEvent.prototype, "error", { enumerable: true });
	Object.defineProperty(ErrorEvent.prototype, "message", { enumerable: true });
	/**
	* Class representing a message event.
	*
	* @extends Event
	*/
	var MessageEvent = class extends Event {
		/**
		* Create a new `MessageEvent`.
		*
		* @param {String} type The name of the event
		* @param {Object} [options] A dictionary object that allows for setting
		*     attributes via object members of the same name
		* @param {*} [options.data=null] The message content
		*/
		constructor(type, options = {}) {
			super(type);
			this[kData] = options.data === void 0 ? null : options.data;
		}
		/**
		* @type {*}
		*/
		get data() {
			return this[kData];
		}
	};
	Object.defineProperty(MessageEvent.prototype, "data", { enumerable: true });
	module.exports = {
		CloseEvent,
		ErrorEvent,
		Event,
		EventTarget: {
			/**
			* Register an event listener.
			*
			* @param {String} type A string representing the event type to listen for
			* @param {(Function|Object)} handler The listener to add
			* @param {Object} [options] An options object specifies characteristics about
			*     the event listener
			* @param {Boolean} [options.once=false] A `Boolean` indicating that the
			*     listener should be invoked at most once after being added. If `true`,
			*     the listener would be automatically removed when invoked.
			* @public
			*/
			addEventListener(type, handler, options = {}) {
				for (const listener of this.listeners(type)) if (!options[kForOnEventAttribute] && listener[kListener] === handler && !listener[kForOnEventAttribute]) return;
				let wrapper;
				if (type === "message") wrapper = function onMessage(data, isBinary) {
					const event = new MessageEvent("message", { data: isBinary ? data : data.toString() });
					event[kTarget] = this;
					callListener(handler, this, event);
				};
				else if (type === "close") wrapper = function onClose(code, message) {
					const event = new CloseEvent("close", {
						code,
						reason: message.toString(),
						wasClean: this._closeFrameReceived && this._closeFrameSent
					});
					event[kTarget] = this;
					callListener(handler, this, event);
				};
				else if (type === "error") wrapper = function onError(error) {
					const event = new ErrorEvent("error", {
						error,
						message: error.message
					});
					event[kTarget] = this;
					callListener(handler, this, event);
				};
				else if (type === "open") wrapper = function onOpen() {
					const event = new Event("open");
					event[kTarget] = this;
					callListener(handler, this, event);
				};
				else return;
				wrapper[kForOnEventAttribute] = !!options[kForOnEventAttribute];
				wrapper[kListener] = handler;
				if (options.once) this.once(type, wrapper);
				else this.on(type, wrapper);
			},
			/**
			* Remove an event listener.
			*
			* @param {String} type A string representing the event type to remove
			* @param {(Function|Object)} handler The listener to remove
			* @public
			*/
			removeEventListener(type, handler) {
				for (const listener of this.listeners(type)) if (listener[kListener] === handler && !listener[kForOnEventAttribute]) {
					this.removeListener(type, listener);
					break;
				}
			}
		},
		MessageEvent
	};
	/**
	* Call an event listener
	*
	* @param {(Function|Object)} listener The listener to call
	* @param {*} thisArg The value to use as `this`` when calling the listener
	* @param {Event} event The event to pass to the listener
	* @private
	*/
	function callListener(listener, thisArg, event) {
		if (typeof listener === "object" && listener.handleEvent) listener.handleEvent.call(listener, event);
		else listener.call(thisArg, event);
	}
}));
// node_modules/ws/lib/extension.js
var require_extension = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { tokenChars } = require_validation();
	/**
	* Adds an offer to the map of extension offers or a parameter to the map of
	* parameters.
	*
	* @param {Object} dest The map of extension offers or parameters
	* @param {String} name The extension or parameter name
	* @param {(Object|Boolean|String)} elem The extension parameters or the
	*     parameter value
	* @private
	*/
	function push(dest, name, elem) {
		if (dest[name] === void 0) dest[name] = [elem];
		else dest[name].push(elem);
	}
	/**
	* Parses the `Sec-WebSocket-Extensions` header into an object.
	*
	* @param {String} header The field value of the header
	* @return {Object} The parsed object
	* @public
	*/
	function parse(header) {
		const offers = Object.create(null);
		let params = Object.create(null);
		let mustUnescape = false;
		let isEscaping = false;
		let inQuotes = false;
		let extensionName;
		let paramName;
		let start = -1;
		let code = -1;
		let end = -1;
		let i = 0;
		for (; i < header.length; i++) {
			code = header.charCodeAt(i);
			if (extensionName === void 0) {
				if (end === -1 && tokenChars[code] === 1) {
					if (start === -1) start = i;
				} else if (i !== 0 && (code === 32 || code === 9)) {
					if (end === -1 && start !== -1) end = i;
				} else if (code === 59 || code === 44) {
					if (start === -1) throw new SyntaxError(`Unexpected character at index ${i}`);
					if (end === -1) end = i;
					const name = header.slice(start, end);
					if (code === 44) {
						push(offers, name, params);
						params = Object.create(null);
					} else extensionName = name;
					start = end = -1;
				} else throw new SyntaxError(`Unexpected character at index ${i}`);
			} else if (paramName === void 0) {
				if (end === -1 && tokenChars[code] === 1) {
					if (start === -1) start = i;
				} else if (code === 32 || code === 9) {
					if (end === -1 && start !== -1) end = i;
				} else if (code === 59 || code === 44) {
					if (start === -1) throw new SyntaxError(`Unexpected character at index ${i}`);
					if (end === -1) end = i;
					push(params, header.slice(start, end), true);
					if (code === 44) {
						push(offers, extensionName, params);
						params = Object.create(null);
						extensionName = void 0;
					}
					start = end = -1;
				} else if (code === 61 && start !== -1 && end === -1) {
					paramName = header.slice(start, i);
					start = end = -1;
				} else throw new SyntaxError(`Unexpected character at index ${i}`);
			} else if (isEscaping) {
				if (tokenChars[code] !== 1) throw new SyntaxError(`Unexpected character at index ${i}`);
				if (start === -1) start = i;
				else if (!mustUnescape) mustUnescape = true;
				isEscaping = false;
			} else if (inQuotes) {
				if (tokenChars[code] === 1) {
					if (start === -1) start = i;
				} else if (code === 34 && start !== -1) {
					inQuotes = false;
					end = i;
				} else if (code === 92) isEscaping = true;
				else throw new SyntaxError(`Unexpected character at index ${i}`);
			} else if (code === 34 && header.charCodeAt(i - 1) === 61) inQuotes = true;
			else if (end === -1 && tokenChars[code] === 1) {
				if (start === -1) start = i;
			} else if (start !== -1 && (code === 32 || code === 9)) {
				if (end === -1) end = i;
			} else if (code === 59 || code === 44) {
				if (start === -1) throw new SyntaxError(`Unexpected character at index ${i}`);
				if (end === -1) end = i;
				let value = header.slice(start, end);
				if (mustUnescape) {
					value = value.replace(/\\/g, "");
					mustUnescape = false;
				}
				push(params, paramName, value);
				if (code === 44) {
					push(offers, extensionName, params);
					params = Object.create(null);
					extensionName = void 0;
				}
				paramName = void 0;
				start = end = -1;
			} else throw new SyntaxError(`Unexpected character at index ${i}`);
		}
		if (start === -1 || inQuotes || code === 32 || code === 9) throw new SyntaxError("Unexpected end of input");
		if (end === -1) end = i;
		const token = header.slice(start, end);
		if (extensionName === void 0) push(offers, token, params);
		else {
			if (paramName === void 0) push(params, token, true);
			else if (mustUnescape) push(params, paramName, token.replace(/\\/g, ""));
			else push(params, paramName, token);
			push(offers, extensionName, params);
		}
		return offers;
	}
	/**
	* Builds the `Sec-WebSocket-Extensions` header field value.
	*
	* @param {Object} extensions The map of extensions and parameters to format
	* @return {String} A string representing the given object
	* @public
	*/
	function format(extensions) {
		return Object.keys(extensions).map((extension) => {
			let configurations = extensions[extension];
			if (!Array.isArray(configurations)) configurations = [configurations];
			return configurations.map((params) => {
				return [extension].concat(Object.keys(params).map((k) => {
					let values = params[k];
					if (!Array.isArray(values)) values = [values];
					return values.map((v) => v === true ? k : `${k}=${v}`).join("; ");
				})).join("; ");
			}).join(", ");
		}).join(", ");
	}
	module.exports = {
		format,
		parse
	};
}));
// node_modules/ws/lib/websocket.js
var require_websocket = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var EventEmitter = __require("events");
	var https = __require("https");
	var http = __require("http");
	var net = __require("net");
	var querystring = __require("querystring");
	var tls = __require("tls");
	var { randomBytes, createHash } = __require("crypto");
	var { Duplex, Readable } = __require("stream");
	var { URL } = __require("url");
	var PerMessageDeflate = require_permessage_deflate();
	var Receiver = require_receiver();
	var Sender = require_sender();
	var { isBlob } = require_validation();
	var { BINARY_TYPES, CLOSE_TIMEOUT, EMPTY_BUFFER, GUID, kForOnEventAttribute, kListener, kStatusCode, kWebSocket, NOOP } = require_constants();
	var { EventTarget: { addEventListener, removeEventListener } } = require_event_target();
	var { format, parse } = require_extension();
	var { toBuffer } = require_buffer_util();
	var kAborted = Symbol("kAborted");
	var protocolVersions = [8, 13];
	var readyStates = [
		"CONNECTING",
		"OPEN",
		"CLOSING",
		"CLOSED"
	];
	var subprotocolRegex = /^[!#$%&'*+\-.0-9A-Z^_`|a-z~]+$/;
	/**
	* Class representing a WebSocket.
	*
	* @extends EventEmitter
	*/
	var WebSocket = class WebSocket extends EventEmitter {
		/**
		* Create a new `WebSocket`.
		*
		* @param {(String|URL)} address The URL to which to connect
		* @param {(String|String[])} [protocols] The subprotocols
		* @param {Object} [options] Connection options
		*/
		constructor(address, protocols, options) {
			super();
			this._binaryType = BINARY_TYPES[0];
			this._closeCode = 1006;
			this._closeFrameReceived = false;
			this._closeFrameSent = false;
			this._closeMessage = EMPTY_BUFFER;
			this._closeTimer = null;
			this._errorEmitted = false;
			this._extensions = {};
			this._paused = false;
			this._protocol = "";
			this._readyState = WebSocket.CONNECTING;
			this._receiver = null;
			this._sender = null;
			this._socket = null;
			if (address !== null) {
				this._bufferedAmount = 0;
				this._isServer = false;
				this._redirects = 0;
				if (protocols === void 0) {
					if (!options || options.protocols === void 0) protocols = [];
					else if (Array.isArray(options.protocols)) protocols = options.protocols;
					else protocols = [options.protocols];
				} else if (!Array.isArray(protocols)) {
					if (typeof protocols === "object" && protocols !== null) {
						options = protocols;
						if (options.protocols === void 0) protocols = [];
						else if (Array.isArray(options.protocols)) protocols = options.protocols;
						else protocols = [options.protocols];
					} else protocols = [protocols];
				}
				options = initAsClient(this, address, protocols, options);
			} else this._isServer = true;
			if (options.autoPong) {
				this._autoPong = true;
				this._autoPongComplete = () => autoPongComplete(this);
				this._pendingAutoPongs = 0;
				this._maxPendingAutoPongs = options.maxPendingAutoPongs | 0;
			}
			this._closeTimeout = options.closeTimeout;
		}
		/**
		* For historical reasons, the custom "nodebuffer" type is used by the default
		* instead of "blob".
		*
		* @type {String}
		*/
		get binaryType() {
			return this._binaryType;
		}
		set binaryType(type) {
			if (!BINARY_TYPES.includes(type)) return;
			this._binaryType = type;
			if (this._receiver) this._receiver._binaryType = type;
		}
		/**
		* @type {Number}
		*/
		get bufferedAmount() {
			if (!this._socket) return this._bufferedAmount;
			return this._socket._writableState.length + this._sender._bufferedBytes;
		}
		/**
		* @type {String}
		*/
		get extensions() {
			return Object.keys(this._extensions).join();
		}
		/**
		* @type {Boolean}
		*/
		get isPaused() {
			return this._paused;
		}
		/**
		* @type {Function}
		*/
		/* istanbul ignore next */
		get onclose() {
			return null;
		}
		/**
		* @type {Function}
		*/
		/* istanbul ignore next */
		get onerror() {
			return null;
		}
		/**
		* @type {Function}
		*/
		/* istanbul ignore next */
		get onopen() {
			return null;
		}
		/**
		* @type {Function}
		*/
		/* istanbul ignore next */
		get onmessage() {
			return null;
		}
		/**
		* @type {String}
		*/
		get protocol() {
			return this._protocol;
		}
		/**
		* @type {Number}
		*/
		get readyState() {
			return this._readyState;
		}
		/**
		* @type {String}
		*/
		get url() {
			return this._url;
		}
		/**
		* Set up the socket and the internal resources.
		*
		* @param {Duplex} socket The network socket between the server and client
		* @param {Buffer} head The first packet of the upgraded stream
		* @param {Object} options Options object
		* @param {Boolean} [options.allowSynchronousEvents=false] Specifies whether
		*     any of the `'message'`, `'ping'`, and `'pong'` events can be emitted
		*     multiple times in the same tick
		* @param {Function} [options.generateMask] The function used to generate the
		*     masking key
		* @param {Number} [options.maxBufferedChunks=0] The maximum number of
		*     buffered data chunks
		* @param {Number} [options.maxFragments=0] The maximum number of message
		*     fragments
		* @param {Number} [options.maxPayload=0] The maximum allowed message size
		* @param {Boolean} [options.skipUTF8Validation=false] Specifies whether or
		*     not to skip UTF-8 validation for text and close messages
		* @private
		*/
		setSocket(socket, head, options) {
			const receiver = new Receiver({
				allowSynchronousEvents: options.allowSynchronousEvents,
				binaryType: this.binaryType,
				extensions: this._extensions,
				isServer: this._isServer,
				maxBufferedChunks: options.maxBufferedChunks,
				maxFragments: options.maxFragments,
				maxPayload: options.maxPayload,
				skipUTF8Validation: options.skipUTF8Validation
			});
			const sender = new Sender(socket, this._extensions, options.generateMask);
			this._receiver = receiver;
			this._sender = sender;
			this._socket = socket;
			receiver[kWebSocket] = this;
			sender[kWebSocket] = this;
			socket[kWebSocket] = this;
			receiver.on("conclude", receiverOnConclude);
			receiver.on("drain", receiverOnDrain);
			receiver.on("error", receiverOnError);
			receiver.on("message", receiverOnMessage);
			receiver.on("ping", receiverOnPing);
			receiver.on("pong", receiverOnPong);
			sender.onerror = senderOnError;
			if (socket.setTimeout) socket.setTimeout(0);
			if (socket.setNoDelay) socket.setNoDelay();
			if (head.length > 0) socket.unshift(head);
			socket.on("close", socketOnClose);
			socket.on("data", socketOnData);
			socket.on("end", socketOnEnd);
			socket.on("error", socketOnError);
			this._readyState = WebSocket.OPEN;
			this.emit("open");
		}
		/**
		* Emit the `'close'` event.
		*
		* @private
		*/
		emitClose() {
			if (!this._socket) {
				this._readyState = WebSocket.CLOSED;
				this.emit("close", this._closeCode, this._closeMessage);
				return;
			}
			if (this._extensions[PerMessageDeflate.extensionName]) this._extensions[PerMessageDeflate.extensionName].cleanup();
			this._receiver.removeAllListeners();
			this._readyState = WebSocket.CLOSED;
			this.emit("close", this._closeCode, this._closeMessage);
		}
		/**
		* Start a closing handshake.
		*
		*          +----------+   +-----------+   +----------+
		*     - - -|ws.close()|-->|close frame|-->|ws.close()|- - -
		*    |     +----------+   +-----------+   +----------+     |
		*          +----------+   +-----------+         |
		* CLOSING  |ws.close()|<--|close frame|<--+-----+       CLOSING
		*          +----------+   +-----------+   |
		*    |           |                        |   +---+        |
		*                +------------------------+-->|fin| - - - -
		*    |         +---+                      |   +---+
		*     - - - - -|fin|<---------------------+
		*              +---+
		*
		* @param {Number} [code] Status code explaining why the connection is closing
		* @param {(String|Buffer)} [data] The reason why the connection is
		*     closing
		* @public
		*/
		close(code, data) {
			if (this.readyState === WebSocket.CLOSED) return;
			if (this.readyState === WebSocket.CONNECTING) {
				abortHandshake(this, this._req, "WebSocket was closed before the connection was established");
				return;
			}
			if (this.readyState === WebSocket.CLOSING) {
				if (this._closeFrameSent && (this._closeFrameReceived || this._receiver._writableState.errorEmitted)) this._socket.end();
				return;
			}
			this._sender.close(code, data, !this._isServer, (err) => {
				if (err) return;
				this._closeFrameSent = true;
				if (this._closeFrameReceived || this._receiver._writableState.errorEmitted) this._socket.end();
			});
			this._readyState = WebSocket.CLOSING;
			setCloseTimer(this);
		}
		/**
		* Pause the socket.
		*
		* @public
		*/
		pause() {
			if (this.readyState === WebSocket.CONNECTING || this.readyState === WebSocket.CLOSED) return;
			this._paused = true;
			this._socket.pause();
		}
		/**
		* Send a ping.
		*
		* @param {*} [data] The data to send
		* @param {Boolean} [mask] Indicates whether or not to mask `data`
		* @param {Function} [cb] Callback which is executed when the ping is sent
		* @public
		*/
		ping(data, mask, cb) {
			if (this.readyState === WebSocket.CONNECTING) throw new Error("WebSocket is not open: readyState 0 (CONNECTING)");
			if (typeof data === "function") {
				cb = data;
				data = mask = void 0;
			} else if (typeof mask === "function") {
				cb = mask;
				mask = void 0;
			}
			if (typeof data === "number") data = data.toString();
			if (this.readyState !== WebSocket.OPEN) {
				sendAfterClose(this, data, cb);
				return;
			}
			if (mask === void 0) mask = !this._isServer;
			this._sender.ping(data || EMPTY_BUFFER, mask, cb);
		}
		/**
		* Send a pong.
		*
		* @param {*} [data] The data to send
		* @param {Boolean} [mask] Indicates whether or not to mask `data`
		* @param {Function} [cb] Callback which is executed when the pong is sent
		* @public
		*/
		pong(data, mask, cb) {
			if (this.readyState === WebSocket.CONNECTING) throw new Error("WebSocket is not open: readyState 0 (CONNECTING)");
			if (typeof data === "function") {
				cb = data;
				data = mask = void 0;
			} else if (typeof mask === "function") {
				cb = mask;
				mask = void 0;
			}
			if (typeof data === "number") data = data.toString();
			if (this.readyState !== WebSocket.OPEN) {
				sendAfterClose(this, data, cb);
				return;
			}
			if (mask === void 0) mask = !this._isServer;
			this._sender.pong(data || EMPTY_BUFFER, mask, cb);
		}
		/**
		* Resume the socket.
		*
		* @public
		*/
		resume() {
			if (this.readyState === WebSocket.CONNECTING || this.readyState === WebSocket.CLOSED) return;
			this._paused = false;
			if (!this._receiver._writableState.needDrain) this._socket.resume();
		}
		/**
		* Send a data message.
		*
		* @param {*} data The message to send
		* @param {Object} [options] Options object
		* @param {Boolean} [options.binary] Specifies whether `data` is binary or
		*     text
		* @param {Boolean} [options.compress] Specifies whether or not to compress
		*     `data`
		* @param {Boolean} [options.fin=true] Specifies whether the fragment is the
		*     last one
		* @param {Boolean} [options.mask] Specifies whether or not to mask `data`
		* @param {Function} [cb] Callback which is executed when data is written out
		* @public
		*/
		send(data, options, cb) {
			if (this.readyState === WebSocket.CONNECTING) throw new Error("WebSocket is not open: readyState 0 (CONNECTING)");
			if (typeof options === "function") {
				cb = options;
				options = {};
			}
			if (typeof data === "number") data = data.toString();
			if (this.readyState !== WebSocket.OPEN) {
				sendAfterClose(this, data, cb);
				return;
			}
			const opts = {
				binary: typeof data !== "string",
				mask: !this._isServer,
				compress: true,
				fin: true,
				...options
			};
			if (!this._extensions[PerMessageDeflate.extensionName]) opts.compress = false;
			this._sender.send(data || EMPTY_BUFFER, opts, cb);
		}
		/**
		* Forcibly close the connection.
		*
		* @public
		*/
		terminate() {
			if (this.readyState === WebSocket.CLOSED) return;
			if (this.readyState === WebSocket.CONNECTING) {
				abortHandshake(this, this._req, "WebSocket was closed before the connection was established");
				return;
			}
			if (this._socket) {
				this._readyState = WebSocket.CLOSING;
				this._socket.destroy();
			}
		}
	};
	/**
	* @constant {Number} CONNECTING
	* @memberof WebSocket
	*/
	Object.defineProperty(WebSocket, "CONNECTING", {
		enumerable: true,
		value: readyStates.indexOf("CONNECTING")
	});
	/**
	* @constant {Number} CONNECTING
	* @memberof WebSocket.prototype
	*/
	Object.defineProperty(WebSocket.prototype, "CONNECTING", {
		enumerable: true,
		value: readyStates.indexOf("CONNECTING")
	});
	/**
	* @constant {Number} OPEN
	* @memberof WebSocket
	*/
	Object.defineProperty(WebSocket, "OPEN", {
		enumerable: true,
		value: readyStates.indexOf("OPEN")
	});
	/**
	* @constant {Number} OPEN
	* @memberof WebSocket.prototype
	*/
	Object.defineProperty(WebSocket.prototype, "OPEN", {
		enumerable: true,
		value: readyStates.indexOf("OPEN")
	});
	/**
	* @constant {Number} CLOSING
	* @memberof WebSocket
	*/
	Object.defineProperty(WebSocket, "CLOSING", {
		enumerable: true,
		value: readyStates.indexOf("CLOSING")
	});
	/**
	* @constant {Number} CLOSING
	* @memberof WebSocket.prototype
	*/
	Object.defineProperty(WebSocket.prototype, "CLOSING", {
		enumerable: true,
		value: readyStates.indexOf("CLOSING")
	});
	/**
	* @constant {Number} CLOSED
	* @memberof WebSocket
	*/
	Object.defineProperty(WebSocket, "CLOSED", {
		enumerable: true,
		value: readyStates.indexOf("CLOSED")
	});
	/**
	* @constant {Number} CLOSED
	* @memberof WebSocket.prototype
	*/
	Object.defineProperty(WebSocket.prototype, "CLOSED", {
		enumerable: true,
		value: readyStates.indexOf("CLOSED")
	});
	[
		"binaryType",
		"bufferedAmount",
		"extensions",
		"isPaused",
		"protocol",
		"readyState",
		"url"
	].forEach((property) => {
		Object.defineProperty(WebSocket.prototype, property, { enumerable: true });
	});
	[
		"open",
		"error",
		"close",
		"message"
	].forEach((method) => {
		Object.defineProperty(WebSocket.prototype, `on${method}`, {
			enumerable: true,
			get() {
				for (const listener of this.listeners(method)) if (listener[kForOnEventAttribute]) return listener[kListener];
				return null;
			},
			set(handler) {
				for (const listener of this.listeners(method)) if (listener[kForOnEventAttribute]) {
					this.removeListener(method, listener);
					break;
				}
				if (typeof handler !== "function") return;
				this.addEventListener(method, handler, { [kForOnEventAttribute]: true });
			}
		});
	});
	WebSocket.prototype.addEventListener = addEventListener;
	WebSocket.prototype.removeEventListener = removeEventListener;
	module.exports = WebSocket;
	/**
	* Initialize a WebSocket client.
	*
	* @param {WebSocket} websocket The client to initialize
	* @param {(String|URL)} address The URL to which to connect
	* @param {Array} protocols The subprotocols
	* @param {Object} [options] Connection options
	* @param {Boolean} [options.allowSynchronousEvents=true] Specifies whether any
	*     of the `'message'`, `'ping'`, and `'pong'` events can be emitted multiple
	*     times in the same tick
	* @param {Boolean} [options.autoPong=true] Specifies whether or not to
	*     automatically send a pong in response to a ping
	* @param {Number} [options.closeTimeout=30000] Duration in milliseconds to wait
	*     for the closing handshake to finish after `websocket.close()` is called
	* @param {Function} [options.finishRequest] A function which can be used to
	*     customize the headers of each http request before it is sent
	* @param {Boolean} [options.followRedirects=false] Whether or not to follow
	*     redirects
	* @param {Function} [options.generateMask] The function used to generate the
	*     masking key
	* @param {Number} [options.handshakeTimeout] Timeout in milliseconds for the
	*     handshake request
	* @param {Number} [options.maxBufferedChunks=262144] The maximum number of
	*     buffered data chunks
	* @param {Number} [options.maxFragments=16384] The maximum number of message
	*     fragments
	* @param {Number} [options.maxPayload=104857600] The maximum allowed message
	*     size
	* @param {Number} [options.maxPendingAutoPongs=60] The maximum number of
	*     pending automatic pongs
	* @param {Number} [options.maxRedirects=10] The maximum number of redirects
	*     allowed
	* @param {String} [options.origin] Value of the `Origin` or
	*     `Sec-WebSocket-Origin` header
	* @param {(Boolean|Object)} [options.perMessageDeflate=true] Enable/disable
	*     permessage-deflate
	* @param {Number} [options.protocolVersion=13] Value of the
	*     `Sec-WebSocket-Version` header
	* @param {Boolean} [options.skipUTF8Validation=false] Specifies whether or
	*     not to skip UTF-8 validation for text and close messages
	* @return {Object} The resolved options object used for initialization
	* @private
	*/
	function initAsClient(websocket, address, protocols, options) {
		const opts = {
			allowSynchronousEvents: true,
			autoPong: true,
			closeTimeout: CLOSE_TIMEOUT,
			protocolVersion: protocolVersions[1],
			maxBufferedChunks: 262144,
			maxFragments: 16384,
			maxPayload: 104857600,
			maxPendingAutoPongs: 60,
			skipUTF8Validation: false,
			perMessageDeflate: true,
			followRedirects: false,
			maxRedirects: 10,
			...options,
			socketPath: void 0,
			hostname: void 0,
			protocol: void 0,
			protocols: void 0,
			timeout: void 0,
			method: "GET",
			host: void 0,
			path: void 0,
			port: void 0
		};
		if (!protocolVersions.includes(opts.protocolVersion)) throw new RangeError(`Unsupported protocol version: ${opts.protocolVersion} (supported versions: ${protocolVersions.join(", ")})`);
		let parsedUrl;
		if (address instanceof URL) parsedUrl = address;
		else try {
			parsedUrl = new URL(address);
		} catch {
			throw new SyntaxError(`Invalid URL: ${address}`);
		}
		if (parsedUrl.protocol === "http:" || parsedUrl.protocol === "https:") {
			parsedUrl = new URL(parsedUrl);
			parsedUrl.protocol = parsedUrl.protocol === "http:" ? "ws:" : "wss:";
		}
		websocket._url = parsedUrl.href;
		const isSecure = parsedUrl.protocol === "wss:";
		const isIpcUrl = parsedUrl.protocol === "ws+unix:";
		let invalidUrlMessage;
		if (parsedUrl.protocol !== "ws:" && !isSecure && !isIpcUrl) invalidUrlMessage = "The URL's protocol must be one of \"ws:\", \"wss:\", \"http:\", \"https:\", or \"ws+unix:\"";
		else if (isIpcUrl && !parsedUrl.pathname) invalidUrlMessage = "The URL's pathname is empty";
		else if (parsedUrl.hash) invalidUrlMessage = "The URL contains a fragment identifier";
		if (invalidUrlMessage) {
			const err = new SyntaxError(invalidUrlMessage);
			if (websocket._redirects === 0) throw err;
			else {
				emitErrorAndClose(websocket, err);
				return;
			}
		}
		const defaultPort = isSecure ? 443 : 80;
		const key = randomBytes(16).toString("base64");
		const request = isSecure ? https.request : http.request;
		const protocolSet = /* @__PURE__ */ new Set();
		let perMessageDeflate;
		opts.createConnection = opts.createConnection || (isSecure ? tlsConnect : netConnect);
		opts.defaultPort = opts.defaultPort || defaultPort;
		opts.port = parsedUrl.port || defaultPort;
		opts.host = parsedUrl.hostname.startsWith("[") ? parsedUrl.hostname.slice(1, -1) : parsedUrl.hostname;
		opts.headers = {
			...opts.headers,
			"Sec-WebSocket-Version": opts.protocolVersion,
			"Sec-WebSocket-Key": key,
			Connection: "Upgrade",
			Upgrade: "websocket"
		};
		opts.path = parsedUrl.pathname + parsedUrl.search;
		opts.timeout = opts.handshakeTimeout;
		if (opts.perMessageDeflate) {
			perMessageDeflate = new PerMessageDeflate({
				...opts.perMessageDeflate,
				isServer: false,
				maxPayload: opts.maxPayload
			});
			opts.headers["Sec-WebSocket-Extensions"] = format({ [PerMessageDeflate.extensionName]: perMessageDeflate.offer() });
		}
		if (protocols.length) {
			for (const protocol of protocols) {
				if (typeof protocol !== "string" || !subprotocolRegex.test(protocol) || protocolSet.has(protocol)) throw new SyntaxError("An invalid or duplicated subprotocol was specified");
				protocolSet.add(protocol);
			}
			opts.headers["Sec-WebSocket-Protocol"] = protocols.join(",");
		}
		if (opts.origin) {
			if (opts.protocolVersion < 13) opts.headers["Sec-WebSocket-Origin"] = opts.origin;
			else opts.headers.Origin = opts.origin;
		}
		if (parsedUrl.username || parsedUrl.password) opts.auth = `${querystring.unescape(parsedUrl.username)}:${querystring.unescape(parsedUrl.password)}`;
		if (isIpcUrl) {
			const i = opts.path.indexOf(":");
			if (i === -1) {
				opts.socketPath = opts.path;
				opts.path = "";
			} else {
				opts.socketPath = opts.path.slice(0, i);
				opts.path = opts.path.slice(i + 1);
			}
		}
		let req;
		if (opts.followRedirects) {
			if (websocket._redirects === 0) {
				websocket._originalIpc = isIpcUrl;
				websocket._originalSecure = isSecure;
				websocket._originalHostOrSocketPath = isIpcUrl ? opts.socketPath : parsedUrl.host;
				const headers = options && options.headers;
				options = {
					...options,
					headers: {}
				};
				if (headers) for (const [key, value] of Object.entries(headers)) options.headers[key.toLowerCase()] = value;
			} else if (websocket.listenerCount("redirect") === 0) {
				const isSameHost = isIpcUrl ? websocket._originalIpc ? opts.socketPath === websocket._originalHostOrSocketPath : false : websocket._originalIpc ? false : parsedUrl.host === websocket._originalHostOrSocketPath;
				if (!isSameHost || websocket._originalSecure && !isSecure) {
					delete opts.headers.authorization;
					delete opts.headers.cookie;
					if (!isSameHost) delete opts.headers.host;
					opts.auth = void 0;
				}
			}
			if (opts.auth && !options.headers.authorization) options.headers.authorization = "Basic " + Buffer.from(opts.auth).toString("base64");
			req = websocket._req = request(opts);
			if (websocket._redirects) websocket.emit("redirect", websocket.url, req);
		} else req = websocket._req = request(opts);
		if (opts.timeout) req.on("timeout", () => {
			abortHandshake(websocket, req, "Opening handshake has timed out");
		});
		req.on("error", (err) => {
			if (req === null || req[kAborted]) return;
			req = websocket._req = null;
			emitErrorAndClose(websocket, err);
		});
		req.on("response", (res) => {
			const location = res.headers.location;
			const statusCode = res.statusCode;
			if (location && opts.followRedirects && statusCode >= 300 && statusCode < 400) {
				if (++websocket._redirects > opts.maxRedirects) {
					abortHandshake(websocket, req, "Maximum redirects exceeded");
					return;
				}
				req.abort();
				let addr;
				try {
					addr = new URL(location, address);
				} catch (e) {
					emitErrorAndClose(websocket, /* @__PURE__ */ new SyntaxError(`Invalid URL: ${location}`));
					return;
				}
				initAsClient(websocket, addr, protocols, options);
			} else if (!websocket.emit("unexpected-response", req, res)) abortHandshake(websocket, req, `Unexpected server response: ${res.statusCode}`);
		});
		req.on("upgrade", (res, socket, head) => {
			websocket.emit("upgrade", res);
			if (websocket.readyState !== WebSocket.CONNECTING) return;
			req = websocket._req = null;
			const upgrade = res.headers.upgrade;
			if (upgrade === void 0 || upgrade.toLowerCase() !== "websocket") {
				abortHandshake(websocket, socket, "Invalid Upgrade header");
				return;
			}
			const digest = createHash("sha1").update(key + GUID).digest("base64");
			if (res.headers["sec-websocket-accept"] !== digest) {
				abortHandshake(websocket, socket, "Invalid Sec-WebSocket-Accept header");
				return;
			}
			const serverProt = res.headers["sec-websocket-protocol"];
			let protError;
			if (serverProt !== void 0) {
				if (!protocolSet.size) protError = "Server sent a subprotocol but none was requested";
				else if (!protocolSet.has(serverProt)) protError = "Server sent an invalid subprotocol";
			} else if (protocolSet.size) protError = "Server sent no subprotocol";
			if (protError) {
				abortHandshake(websocket, socket, protError);
				return;
			}
			if (serverProt) websocket._protocol = serverProt;
			const secWebSocketExtensions = res.headers["sec-websocket-extensions"];
			if (secWebSocketExtensions !== void 0) {
				if (!perMessageDeflate) {
					abortHandshake(websocket, socket, "Server sent a Sec-WebSocket-Extensions header but no extension was requested");
					return;
				}
				let extensions;
				try {
					extensions = parse(secWebSocketExtensions);
				} catch (err) {
					abortHandshake(websocket, socket, "Invalid Sec-WebSocket-Extensions header");
					return;
				}
				const extensionNames = Object.keys(extensions);
				if (extensionNames.length !== 1 || extensionNames[0] !== PerMessageDeflate.extensionName) {
					abortHandshake(websocket, socket, "Server indicated an extension that was not requested");
					return;
				}
				try {
					perMessageDeflate.accept(extensions[PerMessageDeflate.extensionName]);
				} catch (err) {
					abortHandshake(websocket, socket, "Invalid Sec-WebSocket-Extensions header");
					return;
				}
				websocket._extensions[PerMessageDeflate.extensionName] = perMessageDeflate;
			}
			websocket.setSocket(socket, head, {
				allowSynchronousEvents: opts.allowSynchronousEvents,
				generateMask: opts.generateMask,
				maxBufferedChunks: opts.maxBufferedChunks,
				maxFragments: opts.maxFragments,
				maxPayload: opts.maxPayload,
				skipUTF8Validation: opts.skipUTF8Validation
			});
		});
		if (opts.finishRequest) opts.finishRequest(req, websocket);
		else req.end();
		return opts;
	}
	/**
	* Emit the `'error'` and `'close'` events.
	*
	* @param {WebSocket} websocket The WebSocket instance
	* @param {Error} The error to emit
	* @private
	*/
	function emitErrorAndClose(websocket, err) {
		websocket._readyState = WebSocket.CLOSING;
		websocket._errorEmitted = true;
		websocket.emit("error", err);
		websocket.emitClose();
	}
	/**
	* Create a `net.Socket` and initiate a connection.
	*
	* @param {Object} options Connection options
	* @return {net.Socket} The newly created socket used to start the connection
	* @private
	*/
	function netConnect(options) {
		options.path = options.socketPath;
		return net.connect(options);
	}
	/**
	* Create a `tls.TLSSocket` and initiate a connection.
	*
	* @param {Object} options Connection options
	* @return {tls.TLSSocket} The newly created socket used to start the connection
	* @private
	*/
	function tlsConnect(options) {
		options.path = void 0;
		if (!options.servername && options.servername !== "") options.servername = net.isIP(options.host) ? "" : options.host;
		return tls.connect(options);
	}
	/**
	* Abort the handshake and emit an error.
	*
	* @param {WebSocket} websocket The WebSocket instance
	* @param {(http.ClientRequest|net.Socket|tls.Socket)} stream The request to
	*     abort or the socket to destroy
	* @param {String} message The error message
	* @private
	*/
	function abortHandshake(websocket, stream, message) {
		websocket._readyState = WebSocket.CLOSING;
		const err = new Error(message);
		Error.captureStackTrace(err, abortHandshake);
		if (stream.setHeader) {
			stream[kAborted] = true;
			stream.abort();
			if (stream.socket && !stream.socket.destroyed) stream.socket.destroy();
			process.nextTick(emitErrorAndClose, websocket, err);
		} else {
			stream.destroy(err);
			stream.once("error", websocket.emit.bind(websocket, "error"));
			stream.once("close", websocket.emitClose.bind(websocket));
		}
	}
	/**
	* Handle cases where the `ping()`, `pong()`, or `send()` methods are called
	* when the `readyState` attribute is `CLOSING` or `CLOSED`.
	*
	* @param {WebSocket} websocket The WebSocket instance
	* @param {*} [data] The data to send
	* @param {Function} [cb] Callback
	* @private
	*/
	function sendAfterClose(websocket, data, cb) {
		if (data) {
			const length = isBlob(data) ? data.size : toBuffer(data).length;
			if (websocket._socket) websocket._sender._bufferedBytes += length;
			else websocket._bufferedAmount += length;
		}
		if (cb) {
			const err = /* @__PURE__ */ new Error(`WebSocket is not open: readyState ${websocket.readyState} (${readyStates[websocket.readyState]})`);
			process.nextTick(cb, err);
		}
	}
	/**
	* The listener of the `Receiver` `'conclude'` event.
	*
	* @param {Number} code The status code
	* @param {Buffer} reason The reason for closing
	* @private
	*/
	function receiverOnConclude(code, reason) {
		const websocket = this[kWebSocket];
		websocket._closeFrameReceived = true;
		websocket._closeCode = code;
		if (reason.length === 0) websocket._closeMessage = EMPTY_BUFFER;
		else {
			websocket._closeMessage = Buffer.allocUnsafeSlow(reason.length);
			websocket._closeMessage.set(reason);
		}
		if (websocket._socket[kWebSocket] === void 0) return;
		websocket._socket.removeListener("data", socketOnData);
		process.nextTick(resume, websocket._socket);
		if (code === 1005) websocket.close();
		else websocket.close(code, reason);
	}
	/**
	* The listener of the `Receiver` `'drain'` event.
	*
	* @private
	*/
	function receiverOnDrain() {
		const websocket = this[kWebSocket];
		if (!websocket.isPaused) websocket._socket.resume();
	}
	/**
	* The listener of the `Receiver` `'error'` event.
	*
	* @param {(RangeError|Error)} err The emitted error
	* @private
	*/
	function receiverOnError(err) {
		const websocket = this[kWebSocket];
		if (websocket._socket[kWebSocket] !== void 0) {
			websocket._socket.removeListener("data", socketOnData);
			process.nextTick(resume, websocket._socket);
			websocket.close(err[kStatusCode]);
		}
		if (!websocket._errorEmitted) {
			websocket._errorEmitted = true;
			websocket.emit("error", err);
		}
	}
	/**
	* The listener of the `Receiver` `'finish'` event.
	*
	* @private
	*/
	function receiverOnFinish() {
		this[kWebSocket].emitClose();
	}
	/**
	* The listener of the `Receiver` `'message'` event.
	*
	* @param {Buffer|ArrayBuffer|Buffer[])} data The message
	* @param {Boolean} isBinary Specifies whether the message is binary or not
	* @private
	*/
	function receiverOnMessage(data, isBinary) {
		this[kWebSocket].emit("message", data, isBinary);
	}
	/**
	* The listener of the `Receiver` `'ping'` event.
	*
	* @param {Buffer} data The data included in the ping frame
	* @private
	*/
	function receiverOnPing(data) {
		const websocket = this[kWebSocket];
		if (websocket._autoPong && websocket.readyState === WebSocket.OPEN) {
			if (websocket._maxPendingAutoPongs > 0 && websocket._pendingAutoPongs >= websocket._maxPendingAutoPongs) websocket.terminate();
			else {
				websocket._pendingAutoPongs++;
				websocket.pong(data, !this._isServer, websocket._autoPongComplete);
			}
		}
		websocket.emit("ping", data);
	}
	/**
	* The callback for automatic pong responses.
	*
	* @param {WebSocket} websocket The WebSocket instance
	* @private
	*/
	function autoPongComplete(websocket) {
		websocket._pendingAutoPongs--;
	}
	/**
	* The listener of the `Receiver` `'pong'` event.
	*
	* @param {Buffer} data The data included in the pong frame
	* @private
	*/
	function receiverOnPong(data) {
		this[kWebSocket].emit("pong", data);
	}
	/**
	* Resume a readable stream
	*
	* @param {Readable} stream The readable stream
	* @private
	*/
	function resume(stream) {
		stream.resume();
	}
	/**
	* The `Sender` error event handler.
	*
	* @param {Error} The error
	* @private
	*/
	function senderOnError(err) {
		const websocket = this[kWebSocket];
		if (websocket.readyState === WebSocket.CLOSED) return;
		if (websocket.readyState === WebSocket.OPEN) {
			websocket._readyState = WebSocket.CLOSING;
			setCloseTimer(websocket);
		}
		this._socket.end();
		if (!websocket._errorEmitted) {
			websocket._errorEmitted = true;
			websocket.emit("error", err);
		}
	}
	/**
	* Set a timer to destroy the underlying raw socket of a WebSocket.
	*
	* @param {WebSocket} websocket The WebSocket instance
	* @private
	*/
	function setCloseTimer(websocket) {
		websocket._closeTimer = setTimeout(websocket._socket.destroy.bind(websocket._socket), websocket._closeTimeout);
	}
	/**
	* The listener of the socket `'close'` event.
	*
	* @private
	*/
	function socketOnClose() {
		const websocket = this[kWebSocket];
		this.removeListener("close", socketOnClose);
		this.removeListener("data", socketOnData);
		this.removeListener("end", socketOnEnd);
		websocket._readyState = WebSocket.CLOSING;
		if (!this._readableState.endEmitted && !websocket._closeFrameReceived && !websocket._receiver._writableState.errorEmitted && this._readableState.length !== 0) {
			const chunk = this.read(this._readableState.length);
			websocket._receiver.write(chunk);
		}
		websocket._receiver.end();
		this[kWebSocket] = void 0;
		clearTimeout(websocket._closeTimer);
		if (websocket._receiver._writableState.finished || websocket._receiver._writableState.errorEmitted) websocket.emitClose();
		else {
			websocket._receiver.on("error", receiverOnFinish);
			websocket._receiver.on("finish", receiverOnFinish);
		}
	}
	/**
	* The listener of the socket `'data'` event.
	*
	* @param {Buffer} chunk A chunk of data
	* @private
	*/
	function socketOnData(chunk) {
		if (!this[kWebSocket]._receiver.write(chunk)) this.pause();
	}
	/**
	* The listener of the socket `'end'` event.
	*
	* @private
	*/
	function socketOnEnd() {
		const websocket = this[kWebSocket];
		websocket._readyState = WebSocket.CLOSING;
		websocket._receiver.end();
		this.end();
	}
	/**
	* The listener of the socket `'error'` event.
	*
	* @private
	*/
	function socketOnError() {
		const websocket = this[kWebSocket];
		this.removeListener("error", socketOnError);
		this.on("error", NOOP);
		if (websocket) {
			websocket._readyState = WebSocket.CLOSING;
			this.destroy();
		}
	}
}));
// node_modules/ws/lib/stream.js
var require_stream = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	require_websocket();
	var { Duplex } = __require("stream");
	/**
	* Emits the `'close'` event on a stream.
	*
	* @param {Duplex} stream The stream.
	* @private
	*/
	function emitClose(stream) {
		stream.emit("close");
	}
	/**
	* The listener of the `'end'` event.
	*
	* @private
	*/
	function duplexOnEnd() {
		if (!this.destroyed && this._writableState.finished) this.destroy();
	}
	/**
	* The listener of the `'error'` event.
	*
	* @param {Error} err The error
	* @private
	*/
	function duplexOnError(err) {
		this.removeListener("error", duplexOnError);
		this.destroy();
		if (this.listenerCount("error") === 0) this.emit("error", err);
	}
	/**
	* Wraps a `WebSocket` in a duplex stream.
	*
	* @param {WebSocket} ws The `WebSocket` to wrap
	* @param {Object} [options] The options for the `Duplex` constructor
	* @return {Duplex} The duplex stream
	* @public
	*/
	function createWebSocketStream(ws, options) {
		let terminateOnDestroy = true;
		const duplex = new Duplex({
			...options,
			autoDestroy: false,
			emitClose: false,
			objectMode: false,
			writableObjectMode: false
		});
		ws.on("message", function message(msg, isBinary) {
			const data = !isBinary && duplex._readableState.objectMode ? msg.toString() : msg;
			if (!duplex.push(data)) ws.pause();
		});
		ws.once("error", function error(err) {
			if (duplex.destroyed) return;
			terminateOnDestroy = false;
			duplex.destroy(err);
		});
		ws.once("close", function close() {
			if (duplex.destroyed) return;
			duplex.push(null);
		});
		duplex._destroy = function(err, callback) {
			if (ws.readyState === ws.CLOSED) {
				callback(err);
				process.nextTick(emitClose, duplex);
				return;
			}
			let called = false;
			ws.once("error", function error(err) {
				called = true;
				callback(err);
			});
			ws.once("close", function close() {
				if (!called) callback(err);
				process.nextTick(emitClose, duplex);
			});
			if (terminateOnDestroy) ws.terminate();
		};
		duplex._final = function(callback) {
			if (ws.readyState === ws.CONNECTING) {
				ws.once("open", function open() {
					duplex._final(callback);
				});
				return;
			}
			if (ws._socket === null) return;
			if (ws._socket._writableState.finished) {
				callback();
				if (duplex._readableState.endEmitted) duplex.destroy();
			} else {
				ws._socket.once("finish", function finish() {
					callback();
				});
				ws.close();
			}
		};
		duplex._read = function() {
			if (ws.isPaused) ws.resume();
		};
		duplex._write = function(chunk, encoding, callback) {
			if (ws.readyState === ws.CONNECTING) {
				ws.once("open", function open() {
					duplex._write(chunk, encoding, callback);
				});
				return;
			}
			ws.send(chunk, callback);
		};
		duplex.on("end", duplexOnEnd);
		duplex.on("error", duplexOnError);
		return duplex;
	}
	module.exports = createWebSocketStream;
}));
// node_modules/ws/lib/subprotocol.js
var require_subprotocol = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { tokenChars } = require_validation();
	/**
	* Parses the `Sec-WebSocket-Protocol` header into a set of subprotocol names.
	*
	* @param {String} header The field value of the header
	* @return {Set} The subprotocol names
	* @public
	*/
	function parse(header) {
		const protocols = /* @__PURE__ */ new Set();
		let start = -1;
		let end = -1;
		let i = 0;
		for (; i < header.length; i++) {
			const code = header.charCodeAt(i);
			if (end === -1 && tokenChars[code] === 1) {
				if (start === -1) start = i;
			} else if (i !== 0 && (code === 32 || code === 9)) {
				if (end === -1 && start !== -1) end = i;
			} else if (code === 44) {
				if (start === -1) throw new SyntaxError(`Unexpected character at index ${i}`);
				if (end === -1) end = i;
				const protocol = header.slice(start, end);
				if (protocols.has(protocol)) throw new SyntaxError(`The "${protocol}" subprotocol is duplicated`);
				protocols.add(protocol);
				start = end = -1;
			} else throw new SyntaxError(`Unexpected character at index ${i}`);
		}
		if (start === -1 || end !== -1) throw new SyntaxError("Unexpected end of input");
		const protocol = header.slice(start, i);
		if (protocols.has(protocol)) throw new SyntaxError(`The "${protocol}" subprotocol is duplicated`);
		protocols.add(protocol);
		return protocols;
	}
	module.exports = { parse };
}));
// node_modules/ws/lib/websocket-server.js
var require_websocket_server = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var EventEmitter = __require("events");
	var http = __require("http");
	var { Duplex } = __require("stream");
	var { createHash } = __require("crypto");
	var extension = require_extension();
	var PerMessageDeflate = require_permessage_deflate();
	var subprotocol = require_subprotocol();
	var WebSocket = require_websocket();
	var { CLOSE_TIMEOUT, GUID, kWebSocket } = require_constants();
	var keyRegex = /^[+/0-9A-Za-z]{22}==$/;
	var RUNNING = 0;
	var CLOSING = 1;
	var CLOSED = 2;
	/**
	* Class representing a WebSocket server.
	*
	* @extends EventEmitter
	*/
	var WebSocketServer = class extends EventEmitter {
		/**
		* Create a `WebSocketServer` instance.
		*
		* @param {Object} options Configuration options
		* @param {Boolean} [options.allowSynchronousEvents=true] Specifies whether
		*     any of the `'message'`, `'ping'`, and `'pong'` events can be emitted
		*     multiple times in the same tick
		* @param {Boolean} [options.autoPong=true] Specifies whether or not to
		*     automatically send a pong in response to a ping
		* @param {Number} [options.backlog=511] The maximum length of the queue of
		*     pending connections
		* @param {Boolean} [options.clientTracking=true] Specifies whether or not to
		*     track clients
		* @param {Number} [options.closeTimeout=30000] Duration in milliseconds to
		*     wait for the closing handshake to finish after `websocket.close()` is
		*     called
		* @param {Function} [options.handleProtocols] A hook to handle protocols
		* @param {String} [options.host] The hostname where to bind the server
		* @param {Number} [options.maxBufferedChunks=262144] The maximum number of
		*     buffered data chunks
		* @param {Number} [options.maxFragments=16384] The maximum number of message
		*     fragments
		* @param {Number} [options.maxPayload=104857600] The maximum allowed message
		*     size
		* @param {Number} [options.maxPendingAutoPongs=60] The maximum number of
		*     pending automatic pongs
		* @param {Boolean} [options.noServer=false] Enable no server mode
		* @param {String} [options.path] Accept only connections matching this path
		* @param {(Boolean|Object)} [options.perMessageDeflate=false] Enable/disable
		*     permessage-deflate
		* @param {Number} [options.port] The port where to bind the server
		* @param {(http.Server|https.Server)} [options.server] A pre-created HTTP/S
		*     server to use
		* @param {Boolean} [options.skipUTF8Validation=false] Specifies whether or
		*     not to skip UTF-8 validation for text and close messages
		* @param {Function} [options.verifyClient] A hook to reject connections
		* @param {Function} [options.WebSocket=WebSocket] Specifies the `WebSocket`
		*     class to use. It must be the `WebSocket` class or class that extends it
		* @param {Function} [callback] A listener for the `listening` event
		*/
		constructor(options, callback) {
			super();
			options = {
				allowSynchronousEvents: true,
				autoPong: true,
				maxBufferedChunks: 262144,
				maxFragments: 16384,
				maxPayload: 104857600,
				maxPendingAutoPongs: 60,
				skipUTF8Validation: false,
				perMessageDeflate: false,
				handleProtocols: null,
				clientTracking: true,
				closeTimeout: CLOSE_TIMEOUT,
				verifyClient: null,
				noServer: false,
				backlog: null,
				server: null,
				host: null,
				path: null,
				port: null,
				WebSocket,
				...options
			};
			if (options.port == null && !options.server && !options.noServer || options.port != null && (options.server || options.noServer) || options.server && options.noServer) throw new TypeError("One and only one of the \"port\", \"server\", or \"noServer\" options must be specified");
			if (options.port != null) {
				this._server = http.createServer((req, res) => {
					const body = http.STATUS_CODES[426];
					res.writeHead(426, {
						"Content-Length": body.length,
						"Content-Type": "text/plain"
					});
					res.end(body);
				});
				this._server.listen(options.port, options.host, options.backlog, callback);
			} else if (options.server) this._server = options.server;
			if (this._server) {
				const emitConnection = this.emit.bind(this, "connection");
				this._removeListeners = addListeners(this._server, {
					listening: this.emit.bind(this, "listening"),
					error: this.emit.bind(this, "error"),
					upgrade: (req, socket, head) => {
						this.handleUpgrade(req, socket, head, emitConnection);
					}
				});
			}
			if (options.perMessageDeflate === true) options.perMessageDeflate = {};
			if (options.clientTracking) {
				this.clients = /* @__PURE__ */ new Set();
				this._shouldEmitClose = false;
			}
			this.options = options;
			this._state = RUNNING;
		}
		/**
		* Returns the bound address, the address family name, and port of the server
		* as reported by the operating system if listening on an IP socket.
		* If the server is listening on a pipe or UNIX domain socket, the name is
		* returned as a string.
		*
		* @return {(Object|String|null)} The address of the server
		* @public
		*/
		address() {
			if (this.options.noServer) throw new Error("The server is operating in \"noServer\" mode");
			if (!this._server) return null;
			return this._server.address();
		}
		/**
		* Stop the server from accepting new connections and emit the `'close'` event
		* when all existing connections are closed.
		*
		* @param {Function} [cb] A one-time listener for the `'close'` event
		* @public
		*/
		close(cb) {
			if (this._state === CLOSED) {
				if (cb) this.once("close", () => {
					cb(/* @__PURE__ */ new Error("The server is not running"));
				});
				process.nextTick(emitClose, this);
				return;
			}
			if (cb) this.once("close", cb);
			if (this._state === CLOSING) return;
			this._state = CLOSING;
			if (this.options.noServer || this.options.server) {
				if (this._server) {
					this._removeListeners();
					this._removeListeners = this._server = null;
				}
				if (this.clients) {
					if (!this.clients.size) process.nextTick(emitClose, this);
					else this._shouldEmitClose = true;
				} else process.nextTick(emitClose, this);
			} else {
				const server = this._server;
				this._removeListeners();
				this._removeListeners = this._server = null;
				server.close(() => {
					emitClose(this);
				});
			}
		}
		/**
		* See if a given request should be handled by this server instance.
		*
		* @param {http.IncomingMessage} req Request object to inspect
		* @return {Boolean} `true` if the request is valid, else `false`
		* @public
		*/
		shouldHandle(req) {
			if (this.options.path) {
				const index = req.url.indexOf("?");
				if ((index !== -1 ? req.url.slice(0, index) : req.url) !== this.options.path) return false;
			}
			return true;
		}
		/**
		* Handle a HTTP Upgrade request.
		*
		* @param {http.IncomingMessage} req The request object
		* @param {Duplex} socket The network socket between the server and client
		* @param {Buffer} head The first packet of the upgraded stream
		* @param {Function} cb Callback
		* @public
		*/
		handleUpgrade(req, socket, head, cb) {
			socket.on("error", socketOnError);
			const key = req.headers["sec-websocket-key"];
			const upgrade = req.headers.upgrade;
			const version = +req.headers["sec-websocket-version"];
			if (req.method !== "GET") {
				abortHandshakeOrEmitwsClientError(this, req, socket, 405, "Invalid HTTP method");
				return;
			}
			if (upgrade === void 0 || upgrade.toLowerCase() !== "websocket") {
				abortHandshakeOrEmitwsClientError(this, req, socket, 400, "Invalid Upgrade header");
				return;
			}
			if (key === void 0 || !keyRegex.test(key)) {
				abortHandshakeOrEmitwsClientError(this, req, socket, 400, "Missing or invalid Sec-WebSocket-Key header");
				return;
			}
			if (version !== 13 && version !== 8) {
				abortHandshakeOrEmitwsClientError(this, req, socket, 400, "Missing or invalid Sec-WebSocket-Version header", { "Sec-WebSocket-Version": "13, 8" });
				return;
			}
			if (!this.shouldHandle(req)) {
				abortHandshake(socket, 400);
				return;
			}
			const secWebSocketProtocol = req.headers["sec-websocket-protocol"];
			let protocols = /* @__PURE__ */ new Set();
			if (secWebSocketProtocol !== void 0) try {
				protocols = subprotocol.parse(secWebSocketProtocol);
			} catch (err) {
				abortHandshakeOrEmitwsClientError(this, req, socket, 400, "Invalid Sec-WebSocket-Protocol header");
				return;
			}
			const secWebSocketExtensions = req.headers["sec-websocket-extensions"];
			const extensions = {};
			if (this.options.perMessageDeflate && secWebSocketExtensions !== void 0) {
				const perMessageDeflate = new PerMessageDeflate({
					...this.options.perMessageDeflate,
					isServer: true,
					maxPayload: this.options.maxPayload
				});
				try {
					const offers = extension.parse(secWebSocketExtensions);
					if (offers[PerMessageDeflate.extensionName]) {
						perMessageDeflate.accept(offers[PerMessageDeflate.extensionName]);
						extensions[PerMessageDeflate.extensionName] = perMessageDeflate;
					}
				} catch (err) {
					abortHandshakeOrEmitwsClientError(this, req, socket, 400, "Invalid or unacceptable Sec-WebSocket-Extensions header");
					return;
				}
			}
			if (this.options.verifyClient) {
				const info = {
					origin: req.headers[`${version === 8 ? "sec-websocket-origin" : "origin"}`],
					secure: !!(req.socket.authorized || req.socket.encrypted),
					req
				};
				if (this.options.verifyClient.length === 2) {
					this.options.verifyClient(info, (verified, code, message, headers) => {
						if (!verified) return abortHandshake(socket, code || 401, message, headers);
						this.completeUpgrade(extensions, key, protocols, req, socket, head, cb);
					});
					return;
				}
				if (!this.options.verifyClient(info)) return abortHandshake(socket, 401);
			}
			this.completeUpgrade(extensions, key, protocols, req, socket, head, cb);
		}
		/**
		* Upgrade the connection to WebSocket.
		*
		* @param {Object} extensions The accepted extensions
		* @param {String} key The value of the `Sec-WebSocket-Key` header
		* @param {Set} protocols The subprotocols
		* @param {http.IncomingMessage} req The request object
		* @param {Duplex} socket The network socket between the server and client
		* @param {Buffer} head The first packet of the upgraded stream
		* @param {Function} cb Callback
		* @throws {Error} If called more than once with the same socket
		* @private
		*/
		completeUpgrade(extensions, key, protocols, req, socket, head, cb) {
			if (!socket.readable || !socket.writable) return socket.destroy();
			if (socket[kWebSocket]) throw new Error("server.handleUpgrade() was called more than once with the same socket, possibly due to a misconfiguration");
			if (this._state > RUNNING) return abortHandshake(socket, 503);
			const headers = [
				"HTTP/1.1 101 Switching Protocols",
				"Upgrade: websocket",
				"Connection: Upgrade",
				`Sec-WebSocket-Accept: ${createHash("sha1").update(key + GUID).digest("base64")}`
			];
			const ws = new this.options.WebSocket(null, void 0, this.options);
			if (protocols.size) {
				const protocol = this.options.handleProtocols ? this.options.handleProtocols(protocols, req) : protocols.values().next().value;
				if (protocol) {
					headers.push(`Sec-WebSocket-Protocol: ${protocol}`);
					ws._protocol = protocol;
				}
			}
			if (extensions[PerMessageDeflate.extensionName]) {
				const params = extensions[PerMessageDeflate.extensionName].params;
				const value = extension.format({ [PerMessageDeflate.extensionName]: [params] });
				headers.push(`Sec-WebSocket-Extensions: ${value}`);
				ws._extensions = extensions;
			}
			this.emit("headers", headers, req);
			socket.write(headers.concat("\r\n").join("\r\n"));
			socket.removeListener("error", socketOnError);
			ws.setSocket(socket, head, {
				allowSynchronousEvents: this.options.allowSynchronousEvents,
				maxBufferedChunks: this.options.maxBufferedChunks,
				maxFragments: this.options.maxFragments,
				maxPayload: this.options.maxPayload,
				skipUTF8Validation: this.options.skipUTF8Validation
			});
			if (this.clients) {
				this.clients.add(ws);
				ws.on("close", () => {
					this.clients.delete(ws);
					if (this._shouldEmitClose && !this.clients.size) process.nextTick(emitClose, this);
				});
			}
			cb(ws, req);
		}
	};
	module.exports = WebSocketServer;
	/**
	* Add event listeners on an `EventEmitter` using a map of <event, listener>
	* pairs.
	*
	* @param {EventEmitter} server The event emitter
	* @param {Object.<String, Function>} map The listeners to add
	* @return {Function} A function that will remove the added listeners when
	*     called
	* @private
	*/
	function addListeners(server, map) {
		for (const event of Object.keys(map)) server.on(event, map[event]);
		return function removeListeners() {
			for (const event of Object.keys(map)) server.removeListener(event, map[event]);
		};
	}
	/**
	* Emit a `'close'` event on an `EventEmitter`.
	*
	* @param {EventEmitter} server The event emitter
	* @private
	*/
	function emitClose(server) {
		server._state = CLOSED;
		server.emit("close");
	}
	/**
	* Handle socket errors.
	*
	* @private
	*/
	function socketOnError() {
		this.destroy();
	}
	/**
	* Close the connection when preconditions are not fulfilled.
	*
	* @param {Duplex} socket The socket of the upgrade request
	* @param {Number} code The HTTP response status code
	* @param {String} [message] The HTTP response body
	* @param {Object} [headers] Additional HTTP response headers
	* @private
	*/
	function abortHandshake(socket, code, message, headers) {
		message = message || http.STATUS_CODES[code];
		headers = {
			Connection: "close",
			"Content-Type": "text/html",
			"Content-Length": Buffer.byteLength(message),
			...headers
		};
		socket.once("finish", socket.destroy);
		socket.end(`HTTP/1.1 ${code} ${http.STATUS_CODES[code]}\r\n` + Object.keys(headers).map((h) => `${h}: ${headers[h]}`).join("\r\n") + "\r\n\r\n" + message);
	}
	/**
	* Emit a `'wsClientError'` event on a `WebSocketServer` if there is at least
	* one listener for it, otherwise call `abortHandshake()`.
	*
	* @param {WebSocketServer} server The WebSocket server
	* @param {http.IncomingMessage} req The request object
	* @param {Duplex} socket The socket of the upgrade request
	* @param {Number} code The HTTP response status code
	* @param {String} message The HTTP response body
	* @param {Object} [headers] The HTTP response headers
	* @private
	*/
	function abortHandshakeOrEmitwsClientError(server, req, socket, code, message, headers) {
		if (server.listenerCount("wsClientError")) {
			const err = new Error(message);
			Error.captureStackTrace(err, abortHandshakeOrEmitwsClientError);
			server.emit("wsClientError", err, socket, req);
		} else abortHandshake(socket, code, message, headers);
	}
}));
require_stream();
require_extension();
require_permessage_deflate();
require_receiver();
require_sender();
require_subprotocol();
require_websocket();
var import_websocket_server = /* @__PURE__ */ __toESM(require_websocket_server(), 1);
// bridge/cases.ts
var logName = "run.lcm";
async function openCase(folder, id) {
	if (!caseIdPattern.test(id)) return null;
	const opened = await openInside(folder, join(id, logName));
	return typeof opened === "string" ? null : opened;
}
async function listCases(folder) {
	const names = await readdir(folder).catch(() => []);
	return (await Promise.all(names.map((id) => describe(folder, id)))).filter((entry) => entry !== null).sort((a, b) => a.modified < b.modified ? 1 : a.modified > b.modified ? -1 : a.id < b.id ? -1 : 1);
}
async function describe(folder, id) {
	const opened = await openCase(folder, id);
	if (!opened) return null;
	const { mtime } = await opened.file.stat();
	await opened.file.close();
	return {
		id,
		bytes: opened.size,
		modified: mtime.toISOString()
	};
}
// bridge/origins.ts
var Origins = class {
	hosts;
	constructor(bind, port) {
		const all = Object.values(networkInterfaces()).flatMap((found) => (found ?? []).map((one) => one.address));
		const names = [
			"127.0.0.1",
			"localhost",
			...bind === "0.0.0.0" ? all : [bind]
		];
		this.hosts = new Set(names.flatMap((name) => port === 80 ? [name, `${name}:80`] : [`${name}:${port}`]));
	}
	isOurHost(host) {
		return host !== void 0 && this.hosts.has(host.toLowerCase());
	}
	isOurOrigin(origin) {
		if (origin === void 0 || !URL.canParse(origin)) return false;
		const url = new URL(origin);
		return url.protocol === "http:" && url.origin === origin.toLowerCase() && this.isOurHost(url.host);
	}
};
// bridge/web.ts
var security = {
	"X-Content-Type-Options": "nosniff",
	"Referrer-Policy": "no-referrer",
	"Cross-Origin-Resource-Policy": "same-origin",
	"Cross-Origin-Opener-Policy": "same-origin",
	"Cache-Control": "no-store",
	"Content-Security-Policy": "frame-ancestors 'none'"
};
var tilePath = /^\/tiles\/(0|[1-9]\d{0,9})\/(0|[1-9]\d{0,9})\/(0|[1-9]\d{0,9})$/;
var inUse = (port) => `port ${port} is in use; choose another: --port N (make visualizer PORT=N)`;
var Web = class {
	options;
	server;
	sockets;
	origins = new Origins("127.0.0.1", 0);
	constructor(options) {
		this.options = options;
		this.server = createServer({
			maxHeaderSize: 16384,
			requestTimeout: 1e4
		}, (request, response) => {
			this.answer(request, response).catch((error) => this.broken(response, error));
		});
		this.server.maxConnections = 256;
		this.sockets = new import_websocket_server.default({
			noServer: true,
			maxPayload: 4 * maxRequestBytes,
			perMessageDeflate: false,
			handleProtocols: (protocols) => protocols.has("viz.v1") ? subprotocol$1 : false
		});
		this.server.on("upgrade", (request, socket, head) => this.upgrade(request, socket, head));
		this.server.on("clientError", (error, socket) => {
			options.journal.refused("request", `a malformed request: ${error.message}`);
			if (socket.writable) socket.end("HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n");
			else socket.destroy();
		});
	}
	open() {
		const { port, bind } = this.options;
		return new Promise((resolve, reject) => {
			this.server.once("error", (error) => {
				reject(error.code === "EADDRINUSE" ? new Error(inUse(port)) : error);
			});
			this.server.listen(port, bind, () => {
				const address = this.server.address();
				const taken = typeof address === "object" && address ? address.port : port;
				this.origins = new Origins(bind, taken);
				resolve(taken);
			});
		});
	}
	close() {
		this.server.close();
		this.server.closeAllConnections();
	}
	foreign({ headers }, originNeeded) {
		const { host, origin } = headers;
		if (!this.origins.isOurHost(host)) return `Host "${host ?? ""}"`;
		if (origin === void 0 ? originNeeded : !this.origins.isOurOrigin(origin)) return `Origin "${origin ?? ""}"`;
		return "";
	}
	async answer(request, response) {
		const foreign = this.foreign(request, false);
		if (foreign) return this.refuse(request, response, 403, foreign);
		if (request.method !== "GET" && request.method !== "HEAD") return this.refuse(request, response, 405, `${request.method}, expected GET`);
		const path = (request.url ?? "").split("?")[0] ?? "";
		if (path === "/") return this.send(response, "text/html; charset=utf-8", this.options.page);
		if (path === "/healthz") return this.json(response, {
			ok: true,
			pages: this.options.hub.size
		});
		if (path === "/cases") return this.json(response, { cases: await listCases(this.options.cases) });
		const id = /^\/cases\/([^/]*)\.lcm$/.exec(path)?.[1];
		if (id !== void 0) return this.log(request, response, id);
		const tile = tilePath.exec(path);
		if (tile && this.options.tiles) return this.tile(request, response, this.options.tiles, tile);
		return this.refuse(request, response, 404, "no such path");
	}
	async log(request, response, id) {
		const found = await openCase(this.options.cases, id);
		if (!found) return this.refuse(request, response, 404, "no such case");
		await this.stream(request, response, "application/octet-stream", found);
	}
	async tile(request, response, tiles, [, z, x, y]) {
		const found = await openTile(tiles, Number(z), Number(x), Number(y));
		if (found === "refused") return this.refuse(request, response, 404, "no such tile");
		if (found !== "missing") return this.stream(request, response, found.type, found);
		response.writeHead(204, security);
		response.end();
	}
	async stream({ method }, response, type, { file, size }) {
		response.writeHead(200, {
			...security,
			"Content-Type": type,
			"Content-Length": size
		});
		if (method === "HEAD" || size === 0) {
			await file.close();
			response.end();
		} else await pipeline(file.createReadStream({ end: size - 1 }), response);
	}
	json(response, value) {
		this.send(response, "application/json", Buffer.from(JSON.stringify(value)));
	}
	send(response, type, body) {
		response.writeHead(200, {
			...security,
			"Content-Type": type,
			"Content-Length": body.length
		});
		response.end(body);
	}
	refuse(request, response, status, why) {
		this.options.journal.refused("request", `${request.method} ${request.url}: ${why} (${status})`);
		response.writeHead(status, {
			...security,
			"Content-Type": "text/plain",
			Connection: "close"
		});
		response.end(`${why}\n`);
	}
	broken(response, error) {
		this.options.journal.refused("request", `an answer broke off: ${error.message}`);
		response.destroy();
	}
	upgrade(request, socket, head) {
		socket.on("error", () => socket.destroy());
		const refusal = this.refusalOf(request);
		if (refusal) {
			this.options.journal.refused("request", `WebSocket ${request.url}: ${refusal.why} (${refusal.status})`);
			socket.end(`HTTP/1.1 ${refusal.status}\r\nConnection: close\r\nContent-Length: 0\r\n\r\n`);
			return;
		}
		this.sockets.handleUpgrade(request, socket, head, (webSocket) => this.options.hub.add(webSocket));
	}
	refusalOf(request) {
		const foreign = this.foreign(request, true);
		if (foreign) return {
			status: "403 Forbidden",
			why: foreign
		};
		if (request.url !== "/ws") return {
			status: "404 Not Found",
			why: "expected /ws"
		};
		if (!(request.headers["sec-websocket-protocol"] ?? "").split(",").map((name) => name.trim()).includes("viz.v1")) return {
			status: "400 Bad Request",
			why: `expected subprotocol ${subprotocol$1}`
		};
		if (this.options.hub.full) return {
			status: "503 Service Unavailable",
			why: `128 pages are open`
		};
		return null;
	}
};
// bridge/bridge.ts
var goodbyeMs = 500;
var Bridge = class {
	options;
	journal;
	token;
	hub;
	lcm;
	web;
	clock = null;
	constructor(options, pageFile, journal) {
		this.options = options;
		this.journal = journal;
		this.token = options.tokenFile === null ? null : sharedToken(options.tokenFile);
		const page = readFileSync(pageFile);
		const { group, port, bind, cases } = options;
		const tiles = options.tiles === null ? null : readTileFolder(options.tiles);
		this.hub = new Hub({
			group: groupName(group),
			token: this.token,
			tiles: tiles?.set ?? null,
			journal,
			control: (client, request) => this.control(client, request)
		});
		this.lcm = new LcmSocket(group, journal, (channel, payload) => this.hub.message(channel, payload));
		this.web = new Web({
			port,
			bind,
			cases,
			tiles,
			page,
			hub: this.hub,
			journal
		});
	}
	async open() {
		await this.lcm.open();
		const port = await this.web.open();
		this.clock = setInterval(() => {
			this.hub.statistics(this.lcm.stats);
			this.journal.flush();
		}, 1e3);
		return `http://${this.options.bind}:${port}/`;
	}
	async close() {
		if (this.clock) clearInterval(this.clock);
		this.lcm.close();
		this.hub.close();
		for (let waited = 0; this.hub.size > 0 && waited < goodbyeMs; waited += 10) await new Promise((resolve) => setTimeout(resolve, 10));
		this.hub.terminate();
		this.web.close();
		this.journal.flush();
	}
	control(client, { seq, verb, object, args, text }) {
		const payload = encodeControl({
			client,
			token: this.token ?? "",
			seq,
			verb,
			object,
			args,
			text
		});
		return this.lcm.publish(controlChannel, payload);
	}
};
// bridge/journal.ts
var perSecond = 20;
var plain = (text) => text.replace(/\p{Cc}+/gu, " ").slice(0, 300);
var Journal = class {
	write;
	now;
	windows = /* @__PURE__ */ new Map();
	constructor(write, now = () => performance.now()) {
		this.write = write;
		this.now = now;
	}
	say(text) {
		this.write(`bridge: ${plain(text)}`);
	}
	refused(kind, text) {
		const now = this.now();
		const window = this.windows.get(kind) ?? {
			since: now,
			lines: 0,
			more: 0
		};
		this.windows.set(kind, window);
		if (now - window.since >= 1e3) {
			this.flush(kind);
			Object.assign(window, {
				since: now,
				lines: 0
			});
		}
		window.lines += 1;
		if (window.lines <= perSecond) this.say(`refused: ${text}`);
		else window.more += 1;
	}
	flush(...kinds) {
		for (const kind of kinds.length > 0 ? kinds : this.windows.keys()) {
			const window = this.windows.get(kind);
			if (!window || window.more === 0) continue;
			this.say(`refused: ${window.more} more of this kind (${kind})`);
			window.more = 0;
		}
	}
};
// bridge/main.ts
var exitUsage = 2;
var exitCannot = 3;
var exitInterrupted = 130;
function fail(error) {
	const line = String(error.message).split("\n")[0];
	process.stderr.write(`bridge: ${line}\n`);
	process.exit(error instanceof UsageError ? exitUsage : exitCannot);
}
async function run() {
	const options = parseOptions(process.argv.slice(2));
	if (!options) {
		process.stdout.write(`${usage}\n`);
		return;
	}
	const bridge = new Bridge(options, options.page ?? fileURLToPath(new URL("page.html", import.meta.url)), new Journal((line) => process.stderr.write(`${line}\n`)));
	const end = async (status) => {
		await bridge.close();
		process.exit(status);
	};
	process.once("SIGINT", () => void end(exitInterrupted));
	process.once("SIGTERM", () => void end(0));
	const url = await bridge.open();
	const control = options.tokenFile === null ? "control is off" : "control is on";
	process.stdout.write(`bridge: ${url} shows ${groupName(options.group)}; ${control}\n`);
}
run().catch(fail);
export {};
